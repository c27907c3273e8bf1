// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallOperator.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::wallOperator::transposeSums
(
    const scalarField& p,
    vectorField& force,
    const bool films
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
    if (films)
    {
        filmFluxes_.addForce(p, force);
    }

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
    scalarField& Jv,
    const bool films
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
        if (films)
        {
            filmFluxes_.addFlux(v, Jv);
        }
        return;
    }
    heldVelocity_ = v;
    ranks_.spread
    ({
        objectRanks::values::ofWalls(heldVelocity_),
        objectRanks::values::ofObjects(net)
    });
    addFluxLess(net, heldVelocity_, Jv);
    if (films)
    {
        filmFluxes_.addFlux(heldVelocity_, Jv);
    }
}


void Foam::fsi::wallOperator::flux
(
    const vectorField& v,
    scalarField& Jv,
    const vectorField* given
) const
{
    scalarField ofWalls(atWalls_.size(), Zero);
    if (given)
    {
        addFluxAtWalls(*given, ofWalls, true);
        ofWalls.negate();
    }
    addFluxAtWalls(v, ofWalls);
    const labelUList& cells = atWalls_.cells();
    Jv = Zero;
    forAll(cells, i)
    {
        Jv[cells[i]] = ofWalls[i];
    }
}


void Foam::fsi::wallOperator::addGivenFlux(scalarField& Jv) const
{
    const scalarField perArea(givenFlux_*perArea_);
    for (const entry& w : entries_)
    {
        Jv[atWalls_.cells()[w.cell]] += w.share*perArea[w.object];
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
    vectorField& f,
    const bool films
) const
{
    transposeSums(p, f, films);

    // Less the object's mean pressure times J^T 1
    forAll(f, nodei)
    {
        f[nodei] -= meanPressure_[pointObject_[nodei]]*uniformForce_[nodei];
    }
}


// ************************************************************************* //
