// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsConductance.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectsConductance::rowSums(scalarField& d) const
{
    vectorField uniform(system_.walls.uniformForce());
    fsiSystem::groupNodal force;
    system_.objects.layout().toBoundary(uniform, force);

    const scalar dt = system_.stepTime();
    forAll(force, groupi)
    {
        Eigen::MatrixXd v;
        system_.objects.groups()[groupi].response().respondRoughly
        (
            force[groupi],
            v
        );
        force[groupi] = (dt*system_.fluidDensity)*v;
    }
    system_.objects.layout().toSurface(force, uniform);
    system_.walls.addGrossFluxAtWalls(uniform, d);
}


void Foam::fsi::objectsConductance::nodeDiagonal(scalarField& d) const
{
    const scalar dt = system_.stepTime();
    const surfaceSet& surfaces = system_.objects.surfaces();

    // dt rho/A_ii per surface node and component
    vectorField mobility(surfaces.points().size(), Zero);
    forAll(surfaces.pointObject(), nodei)
    {
        const label objecti = surfaces.pointObject()[nodei];
        const label copyi = system_.objects.objectCopy(objecti);
        const bodyGroup& group =
            system_.objects.groups()[system_.objects.objectGroup(objecti)];
        const label i = nodei - surfaces.pointStart()[objecti];
        for (direction d = 0; d < group.shape().nDims(); ++d)
        {
            mobility[nodei][d] =
                dt*system_.fluidDensity
               *group.response().roughMobility(copyi, i, d);
        }
    }

    for (const cellWall& w : system_.geometry.surfaceParts())
    {
        const vector squares(cmptMultiply(w.area, w.area));
        for (label k = 0; k < 3 && w.place.nodes[k] >= 0; ++k)
        {
            d[system_.walls.place(w.cell)] +=
                sqr(w.place.weights[k])
               *(squares & mobility[w.place.nodes[k]]);
        }
    }
}


Foam::scalarField Foam::fsi::objectsConductance::diagonal() const
{
    const label n = system_.walls.cells().size();
    scalarField rows(n, Zero), d(n, Zero);
    rowSums(rows);
    nodeDiagonal(d);
    forAll(d, at)
    {
        d[at] = max(max(rows[at], d[at]), 0.0);
    }
    return d;
}


// ************************************************************************* //
