// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsConductance.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectsConductance::rowSums(scalarField& d) const
{
    vectorField uniform(walls_.uniformForce());
    nodeLayout::groupNodal force;
    bodies_.layout().toBoundary(uniform, force);

    const scalar dt = tau_;
    forAll(force, groupi)
    {
        Eigen::MatrixXd v;
        bodies_.groups()[groupi].response().respondRoughly
        (
            force[groupi],
            v
        );
        force[groupi] = (dt*objects_.fluid().density)*v;
    }
    bodies_.layout().toSurface(force, uniform);
    walls_.addGrossFluxAtWalls(uniform, d);
}


Foam::vectorField Foam::fsi::objectsConductance::nodeMobility() const
{
    const scalar dt = tau_;
    const surfaceSet& surfaces = bodies_.surfaces();
    vectorField mobility(surfaces.points().size(), Zero);
    const label nOwned = surfaces.pointStart()[bodies_.size()];
    for (label nodei = 0; nodei < nOwned; ++nodei)
    {
        const label objecti = surfaces.pointObject()[nodei];
        const label copyi = bodies_.objectCopy(objecti);
        const bodyGroup& group =
            bodies_.groups()[bodies_.objectGroup(objecti)];
        const label i = nodei - surfaces.pointStart()[objecti];
        for (direction d = 0; d < group.shape().nDims(); ++d)
        {
            mobility[nodei][d] =
                dt*objects_.fluid().density
               *group.response().roughMobility(copyi, i, d);
        }
    }

    bodies_.ranks().spread({objectRanks::values::ofWalls(mobility)});
    return mobility;
}


void Foam::fsi::objectsConductance::nodeDiagonal
(
    const vectorField& mobility,
    scalarField& d
) const
{
    for (const cellWall& w : geometry_.surfaceParts())
    {
        const vector squares(cmptMultiply(w.area, w.area));
        for (label k = 0; k < 3 && w.place.nodes[k] >= 0; ++k)
        {
            d[walls_.place(w.cell)] +=
                sqr(w.place.weights[k])
               *(squares & mobility[w.place.nodes[k]]);
        }
    }
}


Foam::scalarField Foam::fsi::objectsConductance::diagonal
(
    const vectorField& mobility
) const
{
    const label n = walls_.cells().size();
    scalarField rows(n, Zero), d(n, Zero);
    rowSums(rows);
    nodeDiagonal(mobility, d);
    forAll(d, at)
    {
        d[at] = max(max(rows[at], d[at]), 0.0);
    }
    return d;
}


// ************************************************************************* //
