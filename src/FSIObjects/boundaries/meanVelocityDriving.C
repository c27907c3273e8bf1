// SPDX-License-Identifier: GPL-3.0-or-later

#include "meanVelocityDriving.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "domainSides.H"
#include "writtenDictionary.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(meanVelocityDriving, 0);
    addToRunTimeSelectionTable(drivingForce, meanVelocityDriving, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Entry velocity; fatal if it is zero
static vector targetVelocity(const dictionary& dict)
{
    checkKeys(dict, {"type", "velocity", "relaxationTime"});
    const vector v(dict.get<vector>("velocity"));
    if (mag(v) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'velocity' in dictionary " << dict.name()
            << " must not be zero" << exit(FatalIOError);
    }
    return v;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::meanVelocityDriving::meanVelocityDriving
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    drivingForce(mesh, dict),
    mesh_(mesh),
    target_(mag(targetVelocity(dict))),
    axis_(targetVelocity(dict)/target_),
    relaxationTime_(readNonNegative(dict, "relaxationTime", 0)),
    acceleration_(0),
    mean_(GREAT)
{
    const vector period(domainSides(mesh).period());
    for (direction d = 0; d < 3; ++d)
    {
        if (mag(axis_[d]) > SMALL && !(period[d] > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'velocity' in dictionary " << dict.name() << " is "
                << targetVelocity(dict) << " but the domain is not cyclic in"
                << " direction " << label(d) << exit(FatalIOError);
        }
    }

    const dictionary state(readState(mesh.time(), "fsiDrivingForce"));
    if (!state.empty())
    {
        acceleration_ = state.get<scalar>("acceleration");
        mean_ = state.get<scalar>("meanVelocity");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::meanVelocityDriving::update(const volVectorField& U)
{
    const scalarField& V = mesh_.V();
    const scalar mean =
        (gSum(V*U.primitiveField()) & axis_)/gSum(V);
    const Time& time = mesh_.time();

    // The step that led here, and the one to come
    scalar resistance = 0;
    if (mean_ < 0.5*GREAT)
    {
        resistance = acceleration_ - (mean - mean_)/time.deltaT0Value();
    }
    // A step cut short by a write time does not have to make up for it all
    const scalar step = max(time.deltaTValue(), time.deltaT0Value());
    acceleration_ = resistance + (target_ - mean)/max(relaxationTime_, step);
    mean_ = mean;
    Info<< "Mean velocity " << mean_ << ", driving acceleration "
        << acceleration_ << endl;
}


void Foam::fsi::meanVelocityDriving::write() const
{
    const Time& time = mesh_.time();
    writeFile
    (
        time, time.timeName(), "uniform", "fsiDrivingForce", IOstream::ASCII,
        [&](Ostream& os)
        {
            os.writeEntry("acceleration", acceleration_);
            os.writeEntry("meanVelocity", mean_);
        }
    );
}


// ************************************************************************* //
