// SPDX-License-Identifier: GPL-3.0-or-later

#include "meanVelocityDriving.H"
#include "errorOf.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "domainSides.H"
#include "openfoamVersion.H"
#include "population.H"
#include "readBetween.H"
#include "sumOverRanks.H"
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
    const vector v(readFinite(dict, "velocity"));
    if (mag(v) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'velocity' in dictionary " << dict.name()
            << " must not be zero" << exit(FatalIOError);
    }
    return v;
}


//- Excess of momentum of the objects that move freely over that of the fluid in
//  their place, over the fluid's density [m4/s]
static vector moreMomentum(const population& objects, const scalar density)
{
    vector sum(Zero);
    for (const bodyGroup& group : objects.groups())
    {
        const shapeTemplate& shape = group.shape();
        const scalar more =
            Foam::sum(shape.nodeMasses())*(1/density - 1/shape.density());
        for (label i = 0; i < group.size() && group.movesFreely(); ++i)
        {
            sum += more*group.velocity(i);
        }
    }
    return sum;
}


//- alpha of (7.3): growth of the mean velocity over the driving acceleration
static scalar meanResponse
(
    const population& objects,
    const scalar density,
    const scalar domainVolume
)
{
    const label other = objects.nDims() - 1;
    scalar light = 0;
    for (const bodyGroup& group : objects.groups())
    {
        const shapeTemplate& shape = group.shape();
        const scalar part =
            Foam::sum(shape.nodeMasses())/shape.density()
           *group.size()/domainVolume;
        if (group.movesFreely())
        {
            light +=
                part*(density - shape.density())
               /(density + other*shape.density());
        }
    }
    return (1 + other*light)/(1 - light);
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
    mean_(GREAT),
    momentum_(0),
    change_(0)
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
        acceleration_ = readEntry<scalar>(state, "acceleration");
        mean_ = readEntry<scalar>(state, "meanVelocity");
        momentum_ = readEntry<scalar>(state, "momentum");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::meanVelocityDriving::update
(
    const volVectorField& U,
    const population& objects,
    const scalar density
)
{
    const scalarField& V = mesh_.V();
    const scalar volume = overRanks(sum(V), sumOp<scalar>());
    const vector flow(overRanks(sum(V*U.primitiveField()), sumOp<vector>()));
    const scalar mean = (flow & axis_)/volume;
    const scalar momentum =
        mean + (moreMomentum(objects, density) & axis_)/volume;
    const Time& time = mesh_.time();

    // The step that led here, and the one to come
    scalar resistance = 0;
    if (mean_ < 0.5*GREAT)
    {
        resistance =
            acceleration_ - (momentum - momentum_)/time.deltaT0Value();
    }
    // A step cut short by a write time does not have to make up for it all
    const scalar step = max(time.deltaTValue(), time.deltaT0Value());
    const scalar last = acceleration_;
    acceleration_ =
        resistance
      + (target_ - mean)
       /(meanResponse(objects, density, volume)*max(relaxationTime_, step));
    change_ = acceleration_ - last;
    mean_ = mean;
    momentum_ = momentum;
}


void Foam::fsi::meanVelocityDriving::log(Ostream& os) const
{
    os  << "Mean velocity " << mean_ << ", driving acceleration "
        << acceleration_ << endl;
}


void Foam::fsi::meanVelocityDriving::write() const
{
    const Time& time = mesh_.time();
    writeFile
    (
        time, nameOf(time), "uniform", "fsiDrivingForce", IOstream::ASCII,
        [&](Ostream& os)
        {
            putEntry(os, "acceleration", acceleration_);
            putEntry(os, "meanVelocity", mean_);
            putEntry(os, "momentum", momentum_);
        }
    );
}


// ************************************************************************* //
