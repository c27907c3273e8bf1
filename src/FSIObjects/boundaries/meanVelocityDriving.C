// SPDX-License-Identifier: GPL-3.0-or-later

#include "meanVelocityDriving.H"
#include "errorOf.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "domainSides.H"
#include "openfoamVersion.H"
#include "population.H"
#include "readBetween.H"
#include "stateFile.H"
#include "sumOverRanks.H"

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

//- Name of a value of the state along an axis
static word stateKey(const char* name, const std::size_t axis)
{
    return axis == 0 ? word(name) : word(name + std::to_string(axis));
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
        const bool counts = group.movesFreely() && group.hasWalls();
        for (label i = 0; i < group.size() && counts; ++i)
        {
            sum += more*group.velocity(i);
        }
    }
    scalarField sums(3);
    for (direction d = 0; d < 3; ++d)
    {
        sums[d] = sum[d];
    }
    objects.ranks().sum(sums);
    return vector(sums[0], sums[1], sums[2]);
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
    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        const shapeTemplate& shape = group.shape();
        const scalar part =
            Foam::sum(shape.nodeMasses())/shape.density()
           *objects.nCopies(groupi)/domainVolume;
        if (group.movesFreely() && group.hasWalls())
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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::meanVelocityDriving::setAxes(const dictionary& dict)
{
    const vector target(readFinite(dict, "velocity"));
    const vector period(domainSides(mesh_).period());
    const scalar speed = mag(target);
    for (direction d = 0; d < 3; ++d)
    {
        if (speed < VSMALL && period[d] > 0)
        {
            vector axis(Zero);
            axis[d] = 1;
            axes_.push_back({axis, 0});
        }
        else if (mag(target[d]) > SMALL*speed && !(period[d] > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'velocity' in dictionary " << dict.name() << " is "
                << target << " but the domain is not cyclic in direction "
                << label(d) << exit(FatalIOError);
        }
    }
    if (speed >= VSMALL)
    {
        axes_.push_back({target/speed, speed});
    }
    if (axes_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Dictionary " << dict.name() << " keeps the mean velocity, but"
            << " the domain is cyclic in no direction" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::meanVelocityDriving::meanVelocityDriving
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    drivingForce(mesh, dict),
    mesh_(mesh),
    relaxationTime_(readNonNegative(dict, "relaxationTime", 0))
{
    checkKeys(dict, {"type", "velocity", "relaxationTime"});
    setAxes(dict);
    const dictionary state(readState(mesh.time(), "fsiDrivingForce"));
    for (std::size_t i = 0; i < axes_.size() && !state.empty(); ++i)
    {
        alongAxis& a = axes_[i];
        a.acceleration = readEntry<scalar>(state, stateKey("acceleration", i));
        a.mean = readEntry<scalar>(state, stateKey("meanVelocity", i));
        a.momentum = readEntry<scalar>(state, stateKey("momentum", i));
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
    scalarField volumes(1, sum(V));
    vectorField velocities(1, sum(V*U.primitiveField()));
    sumOverRanks(velocities, volumes);
    const scalar volume = volumes[0];
    const vector velocity(velocities[0]);
    const vector more(moreMomentum(objects, density));
    const scalar response = meanResponse(objects, density, volume);
    const Time& time = mesh_.time();
    for (alongAxis& a : axes_)
    {
        const scalar mean = (velocity & a.axis)/volume;
        const scalar momentum = mean + (more & a.axis)/volume;

        // The step that led here, and the one to come
        scalar resistance = 0;
        if (a.mean < 0.5*GREAT)
        {
            resistance =
                a.acceleration - (momentum - a.momentum)/time.deltaT0Value();
        }
        // A step cut short by a write time does not have to make up for it all
        const scalar step = max(time.deltaTValue(), time.deltaT0Value());
        const scalar last = a.acceleration;
        a.acceleration =
            resistance
          + (a.target - mean)/(response*max(relaxationTime_, step));
        a.change = a.acceleration - last;
        a.mean = mean;
        a.momentum = momentum;
    }
}


Foam::vector Foam::fsi::meanVelocityDriving::acceleration() const
{
    vector sum(Zero);
    for (const alongAxis& a : axes_)
    {
        sum += a.acceleration*a.axis;
    }
    return sum;
}


Foam::vector Foam::fsi::meanVelocityDriving::change() const
{
    vector sum(Zero);
    for (const alongAxis& a : axes_)
    {
        sum += a.change*a.axis;
    }
    return sum;
}


void Foam::fsi::meanVelocityDriving::log(Ostream& os) const
{
    for (const alongAxis& a : axes_)
    {
        os  << "Mean velocity " << a.mean << ", driving acceleration "
            << a.acceleration;
        if (axes_.size() > 1)
        {
            os  << ", along " << a.axis;
        }
        os  << endl;
    }
}


void Foam::fsi::meanVelocityDriving::write() const
{
    const Time& time = mesh_.time();
    writeFile
    (
        time, nameOf(time), "uniform", "fsiDrivingForce", IOstream::ASCII,
        [&](Ostream& os)
        {
            for (std::size_t i = 0; i < axes_.size(); ++i)
            {
                const alongAxis& a = axes_[i];
                putEntry(os, stateKey("acceleration", i), a.acceleration);
                putEntry(os, stateKey("meanVelocity", i), a.mean);
                putEntry(os, stateKey("momentum", i), a.momentum);
            }
        }
    );
}


// ************************************************************************* //
