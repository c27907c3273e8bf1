// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallOperator.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::wallOperator::transposeSums
(
    const scalarField& p,
    vectorField& force
) const
{
    force.setSize(nNodes_);
    force = Zero;
    meanPressure_ = 0;
    for (const entry& w : entries_)
    {
        const vector load(p[w.cell]*w.area);
        force[w.nodeA] += w.weightA*load;
        force[w.nodeB] += w.weightB*load;
        meanPressure_[w.object] += w.share*p[w.cell];
    }
    meanPressure_ *= perArea_;

    ranks_.collect
    ({
        objectRanks::values::ofWalls(force),
        objectRanks::values::ofObjects(meanPressure_)
    });
}


void Foam::fsi::wallOperator::addFluxLess
(
    const scalarField& net,
    const vectorField& v,
    scalarField& Jv
) const
{
    const scalarField netPerArea(net*perArea_);
    for (const entry& w : entries_)
    {
        Jv[w.cell] +=
            (w.area & (w.weightA*v[w.nodeA] + w.weightB*v[w.nodeB]))
          - w.share*netPerArea[w.object];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallOperator::addFluxAtWalls
(
    const vectorField& v,
    scalarField& Jv
) const
{
    // Net flux 1.J v of each object
    scalarField& net = meanPressure_;
    for (label objecti = 0; objecti < ranks_.nOwned(nObjects_); ++objecti)
    {
        scalar sum = 0;
        for (label i = pointStart_[objecti]; i < pointStart_[objecti + 1]; ++i)
        {
            sum += uniformForce_[i] & v[i];
        }
        net[objecti] = sum;
    }
    if (ranks_.shared())
    {
        addFluxLess(net, v, Jv);
        return;
    }
    heldVelocity_ = v;
    ranks_.spread
    ({
        objectRanks::values::ofWalls(heldVelocity_),
        objectRanks::values::ofObjects(net)
    });
    addFluxLess(net, heldVelocity_, Jv);
}


void Foam::fsi::wallOperator::flux
(
    const vectorField& v,
    scalarField& Jv
) const
{
    scalarField atWalls(cells_.size(), Zero);
    addFluxAtWalls(v, atWalls);
    Jv = Zero;
    forAll(cells_, i)
    {
        Jv[cells_[i]] = atWalls[i];
    }
}


void Foam::fsi::wallOperator::addGivenFlux(scalarField& Jv) const
{
    const scalarField perArea(givenFlux_*perArea_);
    for (const entry& w : entries_)
    {
        Jv[cells_[w.cell]] += w.share*perArea[w.object];
    }
}


void Foam::fsi::wallOperator::addGrossFluxAtWalls
(
    const vectorField& v,
    scalarField& Jv
) const
{
    addFluxLess(scalarField(nObjects_, Zero), v, Jv);
}


void Foam::fsi::wallOperator::transpose
(
    const scalarField& p,
    vectorField& f
) const
{
    transposeAtWalls(atWalls(p), f);
}


void Foam::fsi::wallOperator::transposeAtWalls
(
    const scalarField& p,
    vectorField& f
) const
{
    transposeSums(p, f);

    // Less the object's mean pressure times J^T 1
    forAll(f, nodei)
    {
        f[nodei] -= meanPressure_[pointObject_[nodei]]*uniformForce_[nodei];
    }
}


// ************************************************************************* //
