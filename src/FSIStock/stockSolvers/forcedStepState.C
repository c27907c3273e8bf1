// SPDX-License-Identifier: GPL-3.0-or-later

#include "forcedStep.H"
#include "errorOf.H"
#include "matrixEntry.H"
#include "openfoamVersion.H"
#include "stateFile.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::forcedStep::readState()
{
    const Time& time = objects_.grid().mesh().time();
    const dictionary state(fsi::readState(time, "fsiForcing"));
    if (state.empty())
    {
        return false;
    }
    forAll(load_, groupi)
    {
        const word& shape = objects_.bodies().shape(groupi).name();
        const dictionary& dict = state.subDict(shape);
        if (readEntry<labelList>(dict, "objectIds") != ids_[groupi])
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'objectIds' in dictionary " << dict.name()
                << " has other ids than uniform/fsiObjects/" << shape
                << exit(FatalIOError);
        }
        readMatrix(dict, "load", load_[groupi]);
        readMatrix(dict, "lag", lag_[groupi]);
        readMatrix(dict, "lastVelocity", lastVelocity_[groupi]);
    }
    updateCoverage();
    coefficient_ =
        objects_.grid().cellVolume()
       *scalarField(coefficientField_, coverage_.cells());
    return true;
}


void Foam::fsi::forcedStep::renew()
{
    const PtrList<bodyGroup>& groups = objects_.bodies().groups();
    const groupNodal before(load_);
    objects_.bodies().layout().zero(load_);
    lastVelocity_ = objectVelocities();
    ids_.setSize(groups.size());
    const label nDims = objects_.grid().nDims();
    forAll(groups, groupi)
    {
        const labelList& ids = groups[groupi].objectIds();
        forAll(ids_[groupi], i)
        {
            const label copyi = findIndex(ids, ids_[groupi][i]);
            if (copyi >= 0)
            {
                load_[groupi].middleCols(nDims*copyi, nDims) =
                    before[groupi].middleCols(nDims*i, nDims);
            }
        }
        ids_[groupi] = ids;
    }
    renewed_ = true;
}


void Foam::fsi::forcedStep::writeState() const
{
    const Time& time = objects_.grid().mesh().time();
    writeFile
    (
        time, nameOf(time), "uniform", "fsiForcing", IOstream::ASCII,
        [&](Ostream& os)
        {
            forAll(load_, groupi)
            {
                beginDict(os, objects_.bodies().shape(groupi).name());
                putList(os, "objectIds", ids_[groupi]);
                writeMatrix(os, "load", load_[groupi]);
                writeMatrix(os, "lag", lag_[groupi]);
                writeMatrix(os, "lastVelocity", lastVelocity_[groupi]);
                endDict(os);
            }
        }
    );
}


// ************************************************************************* //
