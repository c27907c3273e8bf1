// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectContact.H"
#include "symmetryPlanePolyPatch.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::fsi::contactWall> Foam::fsi::objectContact::findWalls
(
    const fvMesh& mesh
)
{
    const boundBox bb(mesh.bounds());
    const scalar tolerance = 1e-6*bb.mag();

    // Six sides: lower and upper of each direction
    FixedList<bool, 6> isWall(false);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isA<wallPolyPatch>(patch) && !isA<symmetryPlanePolyPatch>(patch))
        {
            continue;
        }
        for (const point& p : patch.faceCentres())
        {
            for (direction d = 0; d < 3; ++d)
            {
                isWall[2*d] |= mag(p[d] - bb.min()[d]) < tolerance;
                isWall[2*d + 1] |= mag(p[d] - bb.max()[d]) < tolerance;
            }
        }
    }

    DynamicList<contactWall> walls;
    for (direction d = 0; d < 3; ++d)
    {
        vector normal(Zero);
        normal[d] = 1;
        if (returnReduce(isWall[2*d], orOp<bool>()))
        {
            walls.append(contactWall(bb.min(), normal));
        }
        if (returnReduce(isWall[2*d + 1], orOp<bool>()))
        {
            walls.append(contactWall(bb.max(), -normal));
        }
    }
    return List<contactWall>(std::move(walls));
}


Foam::scalar Foam::fsi::objectContact::leastModulus(const population& objects)
{
    scalar least = GREAT;
    forAll(objects.groups(), groupi)
    {
        least = min(least, objects.shape(groupi).youngsModulus());
    }
    return least;
}


void Foam::fsi::objectContact::setResponse(const label groupi)
{
    const population& objects = system_.objects;
    const bodyGroup& group = objects.groups()[groupi];
    const bodyResponse& response = group.response();
    const direction nDims = system_.grid.nDims();
    const label nBoundary = group.shape().nBoundaryNodes();
    const Eigen::MatrixXd* inverse =
        &group.shape().factor(system_.deltaT()).boundaryInverse();

    for (label copyi = 0; copyi < group.size(); ++copyi)
    {
        const label objecti = objects.objectIndex(groupi, copyi);
        const label start = objects.surfaces().pointStart()[objecti];
        const auto add = [&](const Eigen::MatrixXd& values, const scalar s)
        {
            const label k = bodies_.addMode(objecti, s);
            for (label i = 0; i < nBoundary; ++i)
            {
                vector& mode = bodies_.mode(start + i, k);
                mode = Zero;
                for (direction d = 0; d < nDims; ++d)
                {
                    mode[d] = values(i, nDims*copyi + d);
                }
            }
        };

        bodies_.setInverse(objecti, inverse);
        add(response.rotationModes(), 1);
        add(response.elasticRotation(), -1);
        add(response.volumeMode(), -1/response.volumeCompliance()[copyi]);
    }
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

    List<pointField> positions(Pstream::nProcs());
    List<labelList> objects(Pstream::nProcs());
    pointField& myPositions = positions[Pstream::myProcNo()];
    labelList& myObjects = objects[Pstream::myProcNo()];
    for (const medialAxisPoint& p : axis_->points())
    {
        myPositions.append(p.position);
        myObjects.append(p.object[0]);
        myObjects.append(p.object[1]);
    }
    Pstream::gatherList(positions);
    Pstream::scatterList(positions);
    Pstream::gatherList(objects);
    Pstream::scatterList(objects);

    axisPoints_.clear();
    forAll(positions, ranki)
    {
        forAll(positions[ranki], i)
        {
            contactMedialPoint p;
            p.position = positions[ranki][i];
            p.objects[0] = objects[ranki][2*i];
            p.objects[1] = objects[ranki][2*i + 1];
            axisPoints_.append(p);
        }
    }
}


void Foam::fsi::objectContact::setBodies()
{
    const population& objects = system_.objects;
    const surfaceSet& surfaces = objects.surfaces();

    bodies_.reset(surfaces);
    fsiSystem::groupNodal internal;
    objects.zeroGroups(internal);

    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        const shapeTemplate& shape = group.shape();
        if (group.free())
        {
            setResponse(groupi);
        }
        if (contact_.needsInternalForces())
        {
            group.internalForce(internal[groupi]);
        }

        const scalarField areas
        (
            contactBodies::nodeAreas
            (
                shape.points(),
                shape.faces(),
                system_.grid.nDims(),
                system_.grid.thickness()
            )
        );
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            const label start =
                surfaces.pointStart()[objects.objectIndex(groupi, copyi)];
            for (label i = 0; i < shape.nBoundaryNodes(); ++i)
            {
                bodies_.areas()[start + i] = areas[i];
            }
        }
    }
    bodies_.masses() = objects.nodeMass();
    objects.toSurface(internal, bodies_.internalForces());
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
        leastModulus(system.objects)
    ),
    walls_(findWalls(system.grid.mesh())),
    nLimited_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectContact::push(fsiSystem::groupNodal& v)
{
    setBodies();
    if (contact_.needsMedialAxis())
    {
        findAxis();
    }
    withVelocities
    (
        v,
        [&]()
        {
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
    );
    respond(v);
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
