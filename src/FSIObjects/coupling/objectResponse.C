// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectResponse.H"
#include "rigidForce.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addNetForce
(
    const fsiSystem& system,
    const vectorField& nodal,
    List<Eigen::MatrixXd>& force
)
{
    List<Eigen::MatrixXd> boundary;
    system.objects.layout().toBoundary(nodal, boundary);
    forAll(force, groupi)
    {
        const bodyGroup& group = system.objects.groups()[groupi];
        const auto add =
            group.hasFreeWaves() ? addSurfaceForce : addRigidForce;
        add(group, boundary[groupi], force[groupi]);
    }
}


void Foam::fsi::expectPressure(fsiSystem& system, const scalarField& change)
{
    vectorField nodal;
    system.walls.transpose(change, nodal);
    nodal *= system.fluidDensity;
    List<Eigen::MatrixXd> load;
    system.objects.layout().toBoundary(nodal, load);
    forAll(load, groupi)
    {
        system.objects.groups()[groupi].expectLoad(load[groupi]);
    }
}


void Foam::fsi::addResponse
(
    const population& objects,
    const List<Eigen::MatrixXd>& force,
    List<Eigen::MatrixXd>& velocity
)
{
    forAll(force, groupi)
    {
        if (force[groupi].size())
        {
            Eigen::MatrixXd v;
            objects.groups()[groupi].response().respond(force[groupi], v);
            velocity[groupi] += v;
        }
    }
}


// ************************************************************************* //
