// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectResponse.H"
#include "rigidForce.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::predictObjects
(
    const population& bodies,
    const scalar time,
    const stepLength& step,
    const List<Eigen::MatrixXd>& force,
    List<Eigen::MatrixXd>& velocity
)
{
    velocity.resize(force.size());
    forAll(velocity, groupi)
    {
        velocity[groupi].resize(force[groupi].rows(), force[groupi].cols());
        if (velocity[groupi].size())
        {
            bodies.groups()[groupi].predict
            (
                time, step.tau, force[groupi], velocity[groupi]
            );
        }
    }
}


Foam::List<Eigen::MatrixXd> Foam::fsi::splitLoads
(
    population& bodies,
    List<Eigen::MatrixXd>& load
)
{
    List<Eigen::MatrixXd> rest(load.size());
    forAll(rest, groupi)
    {
        rest[groupi] = bodies.groups()[groupi].splitLoad(load[groupi]);
    }
    return rest;
}


void Foam::fsi::keepLoads
(
    population& bodies,
    const List<Eigen::MatrixXd>& load
)
{
    forAll(load, groupi)
    {
        bodies.groups()[groupi].keepLoad(load[groupi]);
    }
}


void Foam::fsi::addNetForce
(
    const population& bodies,
    const vectorField& nodal,
    List<Eigen::MatrixXd>& force
)
{
    List<Eigen::MatrixXd> boundary;
    bodies.layout().toBoundary(nodal, boundary);
    forAll(force, groupi)
    {
        const bodyGroup& group = bodies.groups()[groupi];
        const auto add =
            group.hasFreeWaves() ? addSurfaceForce : addRigidForce;
        if (group.hasWalls())
        {
            add(group, boundary[groupi], force[groupi]);
        }
    }
}


void Foam::fsi::expectPressure
(
    population& bodies,
    const wallOperator& walls,
    const scalar density,
    const scalarField& change
)
{
    vectorField nodal;
    walls.transpose(change, nodal);
    nodal *= density;
    List<Eigen::MatrixXd> load;
    bodies.layout().toBoundary(nodal, load);
    forAll(load, groupi)
    {
        bodies.groups()[groupi].expectLoad(load[groupi]);
    }
}


void Foam::fsi::addResponse
(
    const population& bodies,
    const List<Eigen::MatrixXd>& force,
    List<Eigen::MatrixXd>& velocity
)
{
    forAll(force, groupi)
    {
        const bodyGroup& group = bodies.groups()[groupi];
        if (force[groupi].size() && group.hasWalls())
        {
            Eigen::MatrixXd v;
            group.response().respond(force[groupi], v);
            velocity[groupi] += v;
        }
    }
}


// ************************************************************************* //
