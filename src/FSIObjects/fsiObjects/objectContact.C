// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectContact.H"
#include "contactJumps.H"
#include "leastModulus.H"
#include "needAllObjects.H"
#include "rankExchange.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectContact::findAxis()
{
    if (!axis_.valid())
    {
        axis_.reset(new medialAxis(contact_.range(), grid_.spacing()));
    }
    axis_->update(surfaces(), grid_.cells(1));

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
    if (contact_.needsMedialAxis() && !contact_.searched(surfaces()))
    {
        findAxis();
    }
}


Foam::List<Foam::labelList> Foam::fsi::objectContact::objectsOfGroups
(
    const label nObjects
) const
{
    List<DynamicList<label>> objects(bodies_.groups().size());
    for (label objecti = 0; objecti < nObjects; ++objecti)
    {
        const label groupi = bodies_.objectGroup(objecti);
        if (bodies_.groups()[groupi].hasWalls())
        {
            objects[groupi].append(objecti);
        }
    }
    List<labelList> result(objects.size());
    forAll(result, groupi)
    {
        result[groupi] = objects[groupi];
    }
    return result;
}


void Foam::fsi::objectContact::setNodes()
{
    nodes_.reset(surfaces());
    for (label objecti = 0; objecti < bodies_.nHeld(); ++objecti)
    {
        nodes_.setId(objecti, bodies_.objectId(objecti));
        if (objecti >= bodies_.size())
        {
            nodes_.setGuest(objecti);
        }
    }
    const List<labelList> objects(objectsOfGroups(bodies_.nHeld()));

    groups_.resize(bodies_.groups().size());
    forAll(bodies_.groups(), groupi)
    {
        const bodyGroup& group = bodies_.groups()[groupi];
        if (!groups_[groupi])
        {
            groups_[groupi].reset(new groupContact(group, contact_.range()));
        }
        groups_[groupi]->setNodes(surfaces(), objects[groupi], nodes_);
        const scalar added =
            contactFilm::addedMass(grid_.nDims())
           *fluid_.density/group.shape().density();
        for (const label objecti : objects[groupi])
        {
            nodes_.setAddedMass(objecti, added);
        }
    }
}


void Foam::fsi::objectContact::setRanges()
{
    scalarField& ranges = contact_.ranges();
    ranges.setSize(bodies_.nHeld());
    ranges = contact_.range();
    for (label objecti = 0; objecti < bodies_.size(); ++objecti)
    {
        const scalar range = contactRange(objecti);
        ranges[objecti] =
            range < 0 || !bodies_.movesFreely(objecti)
          ? contact_.range()
          : range;
    }
    bodies_.ranks().spread({objectRanks::values::ofObjects(ranges)});
}


void Foam::fsi::objectContact::keepRanges()
{
    const scalarField& ranges = contact_.ranges();
    for (label i = 0; i < bodies_.size(); ++i)
    {
        contactRange(i) = ranges[i] < contact_.range() ? ranges[i] : -1;
    }
}


void Foam::fsi::objectContact::take()
{
    setNodes();
    const List<labelList> objects(objectsOfGroups(bodies_.size()));
    forAll(groups_, groupi)
    {
        groups_[groupi]->setResponse
        (
            surfaces(),
            objects[groupi],
            contact_.needsInternalForces(),
            nodes_
        );
    }
    setRanges();
    prepareSearch();
    force_.setSize(surfaces().points().size(), vector(Zero));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectContact::objectContact
(
    population& bodies,
    const cartesianMesh& grid,
    const domainSides& sides,
    const dictionary& properties,
    const fluidProperties& fluid
)
:
    bodies_(bodies),
    grid_(grid),
    sides_(sides),
    contact_
    (
        properties.subOrEmptyDict("contact"),
        grid.nDims(),
        grid.spacing(),
        leastModulus(bodies),
        sides.images()
    ),
    walls_(sides.walls()),
    fluid_(fluid),
    inFluid_(couplingType(properties) != "none"),
    nLimited_(0)
{
    checkRoughness(properties.subOrEmptyDict("contact"), bodies);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectContact::calculate
(
    const vectorField& velocities,
    const stepLength& step
)
{
    take();
    const vectorField start(lessStandstill(surfaces().velocities(), step));
    contactStep times(step.tau, step.dt, &start);
    if (inFluid_)
    {
        setFluid(bodies_, fluid_, grid_, times);
    }
    contact_.calculate
    (
        surfaces(),
        velocities,
        nodes_,
        walls_,
        axisPoints_,
        times,
        force_
    );
    keepRanges();
}


void Foam::fsi::objectContact::share()
{
    exchange_ = std::make_unique<rankExchange>(bodies_.ranks());
    contact_.setExchange(*exchange_);
}


void Foam::fsi::objectContact::measure()
{
    start_.clear();
    setNodes();
    setRanges();
    prepareSearch();
    contact_.measure(surfaces(), nodes_, walls_, axisPoints_);
    keepRanges();
}


void Foam::fsi::objectContact::addForce
(
    nodeLayout::groupNodal& force,
    const stepLength& step
)
{
    carry_.clear();
    if (explicitForces())
    {
        calculate(surfaces().velocities(), step);
        nodeLayout::groupNodal contactForce;
        bodies_.layout().toGroups(force_, contactForce);
        nodeLayout::add(contactForce, force);
    }
}


// ************************************************************************* //
