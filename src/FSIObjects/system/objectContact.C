// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectContact.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::objectContact::leastModulus(const population& objects)
{
    scalar least = GREAT, leastFree = GREAT;
    for (const bodyGroup& group : objects.groups())
    {
        least = min(least, group.shape().youngsModulus());
        if (group.free())
        {
            leastFree = min(leastFree, group.shape().youngsModulus());
        }
    }
    if (leastFree < GREAT)
    {
        return leastFree;
    }
    // Without shapes nothing touches, and any value will do
    return objects.groups().empty() ? 1 : least;
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
    axis_->update(system_.objects.surfaces(), system_.grid.cells(1));

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
     && !contact_.searched(system_.objects.surfaces())
    )
    {
        findAxis();
    }
}


void Foam::fsi::objectContact::setNodes()
{
    const population& objects = system_.objects;
    bodies_.reset(objects.surfaces());

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
            objects.surfaces(), objectsOf(groupi), bodies_
        );
    }
}


void Foam::fsi::objectContact::setBodies()
{
    setNodes();
    forAll(groups_, groupi)
    {
        groups_[groupi]->setResponse
        (
            system_.objects.surfaces(),
            objectsOf(groupi),
            contact_.needsInternalForces(),
            bodies_
        );
    }
}


void Foam::fsi::objectContact::withVelocities
(
    const fsiSystem::groupNodal& v,
    const std::function<void()>& look
)
{
    vectorField& velocities = system_.objects.surfaces().velocities();
    vectorField kept(velocities);
    system_.objects.toSurface(v, velocities);
    look();
    velocities = kept;
}


void Foam::fsi::objectContact::respond(fsiSystem::groupNodal& v) const
{
    fsiSystem::groupNodal force;
    system_.objects.toGroups(force_, force);
    forAll(v, groupi)
    {
        const bodyGroup& group = system_.objects.groups()[groupi];
        if (group.free())
        {
            Eigen::MatrixXd change(v[groupi].rows(), v[groupi].cols());
            group.respond(force[groupi], change);
            v[groupi] += change;
        }
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
        leastModulus(system.objects),
        system.fluidDensity*system.viscosity,
        system.sides.images()
    ),
    walls_(system.sides.walls()),
    nLimited_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectContact::calculate()
{
    setBodies();
    prepareSearch();
    contact_.calculate
    (
        system_.objects.surfaces(),
        bodies_,
        walls_,
        axisPoints_,
        system_.deltaT(),
        force_
    );
}


void Foam::fsi::objectContact::measure()
{
    setNodes();
    prepareSearch();
    contact_.measure
    (
        system_.objects.surfaces(), bodies_, walls_, axisPoints_
    );
}


void Foam::fsi::objectContact::push(fsiSystem::groupNodal& v)
{
    if (!explicitForces())
    {
        withVelocities
        (
            v,
            [this]()
            {
                calculate();
            }
        );
        respond(v);
    }
}


void Foam::fsi::objectContact::addForce(fsiSystem::groupNodal& force)
{
    if (explicitForces())
    {
        calculate();
        fsiSystem::groupNodal contactForce;
        system_.objects.toGroups(force_, contactForce);
        forAll(force, groupi)
        {
            force[groupi] += contactForce[groupi];
        }
    }
}


void Foam::fsi::objectContact::limit(fsiSystem::groupNodal& v)
{
    withVelocities
    (
        v,
        [&]()
        {
            nLimited_ = contact_.limit
            (
                system_.objects.surfaces(),
                bodies_,
                walls_,
                system_.deltaT(),
                force_
            );
        }
    );
    if (nLimited_ > 0)
    {
        respond(v);
    }
}


// ************************************************************************* //
