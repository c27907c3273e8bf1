// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectContact.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "sumOverRanks.H"
#include "writtenDictionary.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::objectContact::leastModulus(const fsiSystem& system)
{
    const PtrList<bodyGroup>& groups = system.objects.groups();
    // A step of zero is refused later, with its entry
    const scalar speed = system.grid.spacing()/max(system.deltaT(), SMALL);
    scalar least = GREAT, leastFree = GREAT;
    for (const bodyGroup& group : groups)
    {
        const shapeTemplate& shape = group.shape();
        const scalar modulus =
            shape.rigid()
          ? shape.density()*sqr(speed)
          : shape.youngsModulus();
        least = min(least, modulus);
        if (group.movesFreely())
        {
            leastFree = min(leastFree, modulus);
        }
    }
    if (leastFree < GREAT)
    {
        return leastFree;
    }
    // Without shapes nothing touches, and any value will do
    return groups.empty() ? 1 : least;
}


void Foam::fsi::objectContact::findAxis()
{
    if (!axis_.valid())
    {
        axis_.reset
        (
            new medialAxis(contact_.range(), system_.grid.spacing())
        );
    }
    axis_->update(surfaces(), system_.grid.cells(1));

    pointField myPositions;
    scalarList myDistances;
    labelList myObjects;
    for (const medialAxisPoint& p : axis_->points())
    {
        myPositions.append(p.position);
        myDistances.append(p.distance);
        myObjects.append(p.object[0]);
        myObjects.append(p.object[1]);
    }
    const List<pointField> positions(gatherOverRanks(myPositions));
    const List<scalarList> distances(gatherOverRanks(myDistances));
    const List<labelList> objects(gatherOverRanks(myObjects));

    axisPoints_.clear();
    forAll(positions, ranki)
    {
        forAll(positions[ranki], i)
        {
            medialAxisPoint p;
            p.position = positions[ranki][i];
            p.distance = distances[ranki][i];
            p.object[0] = objects[ranki][2*i];
            p.object[1] = objects[ranki][2*i + 1];
            axisPoints_.append(p);
        }
    }
}


void Foam::fsi::objectContact::prepareSearch()
{
    if
    (
        contact_.needsMedialAxis()
     && !contact_.searched(surfaces())
    )
    {
        findAxis();
    }
}


void Foam::fsi::objectContact::setNodes()
{
    const population& objects = system_.objects;
    bodies_.reset(surfaces());
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        bodies_.setId(objecti, objects.objectId(objecti));
    }

    groups_.resize(objects.groups().size());
    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        if (!groups_[groupi])
        {
            groups_[groupi] = std::make_unique<groupContact>(group);
        }
        groups_[groupi]->setNodes
        (
            surfaces(), objectsOf(groupi), bodies_
        );
    }
}


void Foam::fsi::objectContact::setRanges()
{
    const population& objects = system_.objects;
    scalarField& ranges = contact_.ranges();
    ranges.setSize(objects.size());
    forAll(ranges, objecti)
    {
        const label id = objects.objectId(objecti);
        ranges[objecti] =
            !objects.movesFreely(objecti) ? contact_.range()
          : id >= nextObjectId_ ? 0
          : valueOr(shortRanges_, id, contact_.range());
    }
}


void Foam::fsi::objectContact::keepRanges()
{
    const scalarField& ranges = contact_.ranges();
    shortRanges_.clear();
    forAll(ranges, objecti)
    {
        if (ranges[objecti] < contact_.range())
        {
            shortRanges_.insert
            (
                system_.objects.objectId(objecti), ranges[objecti]
            );
        }
    }
    nextObjectId_ = system_.objects.nextObjectId();
}


void Foam::fsi::objectContact::setBodies()
{
    setNodes();
    forAll(groups_, groupi)
    {
        groups_[groupi]->setResponse
        (
            surfaces(),
            objectsOf(groupi),
            contact_.needsInternalForces(),
            bodies_
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectContact::objectContact(fsiSystem& system)
:
    system_(system),
    contact_
    (
        system.properties.subOrEmptyDict("contact"),
        system.grid.nDims(),
        system.grid.spacing(),
        leastModulus(system),
        system.fluidDensity*system.viscosity,
        system.sides.images()
    ),
    walls_(system.sides.walls()),
    nextObjectId_(0),
    nLimited_(0)
{
    const dictionary state(readState(system.grid.mesh().time(), "fsiContact"));
    nextObjectId_ = readEntryOr<label>(state, "nextObjectId", nextObjectId_);
    state.readIfPresent("ranges", shortRanges_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectContact::calculate(const vectorField& velocities)
{
    setBodies();
    setRanges();
    prepareSearch();
    contact_.calculate
    (
        surfaces(),
        velocities,
        bodies_,
        walls_,
        axisPoints_,
        system_.stepTime(),
        force_,
        1 - system_.stepTime()/system_.deltaT()
    );
    keepRanges();
}


void Foam::fsi::objectContact::measure()
{
    start_.clear();
    setNodes();
    setRanges();
    prepareSearch();
    contact_.measure
    (
        surfaces(), bodies_, walls_, axisPoints_
    );
    keepRanges();
}


void Foam::fsi::objectContact::addForce(fsiSystem::groupNodal& force)
{
    if (explicitForces())
    {
        calculate(surfaces().velocities());
        fsiSystem::groupNodal contactForce;
        system_.objects.layout().toGroups(force_, contactForce);
        forAll(force, groupi)
        {
            force[groupi] += contactForce[groupi];
        }
    }
}


void Foam::fsi::objectContact::write() const
{
    const Time& time = system_.grid.mesh().time();
    writeFile
    (
        time, nameOf(time), "uniform", "fsiContact", IOstream::ASCII,
        [&](Ostream& os)
        {
            putEntry(os, "nextObjectId", nextObjectId_);
            putEntry(os, "ranges", shortRanges_);
        }
    );
}


// ************************************************************************* //
