// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallOperator.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<Foam::fsi::wallOperator::sides Sides>
void Foam::fsi::wallOperator::addTranspose
(
    const scalarField& p,
    vectorField& force
) const
{
    const UList<entry>& entries = entries_[Sides];
    scalar* components = reinterpret_cast<scalar*>(force.begin());
    for (const entry& w : entries)
    {
        const scalar lower = Sides != UPPER ? p[w.lower] : 0;
        const scalar upper = Sides != LOWER ? p[w.upper] : 0;
        components[w.placeA] += w.areaA*(lower - upper);
        components[w.placeB] += w.areaB*(lower - upper);
        meanPressure_[w.object] += (w.areaA + w.areaB)*(lower + upper);
    }
}


template<Foam::fsi::wallOperator::sides Sides>
void Foam::fsi::wallOperator::addFlux
(
    const scalarField& netPerArea,
    const vectorField& v,
    scalarField& Jv
) const
{
    const UList<entry>& entries = entries_[Sides];
    const scalar* components = reinterpret_cast<const scalar*>(v.cdata());
    for (const entry& w : entries)
    {
        const scalar q =
            w.areaA*components[w.placeA] + w.areaB*components[w.placeB];
        const scalar spread = (w.areaA + w.areaB)*netPerArea[w.object];
        if (Sides != UPPER)
        {
            Jv[w.lower] += q - spread;
        }
        if (Sides != LOWER)
        {
            Jv[w.upper] -= q + spread;
        }
    }
}


void Foam::fsi::wallOperator::transposeSums
(
    const scalarField& p,
    vectorField& force
) const
{
    force.setSize(nNodes_);
    force = Zero;
    meanPressure_ = 0;
    addTranspose<BOTH>(p, force);
    addTranspose<LOWER>(p, force);
    addTranspose<UPPER>(p, force);
    meanPressure_ *= perArea_;

    if (Pstream::parRun())
    {
        // One exchange for both: the means behind the forces
        exchange_.setSize(nNodes_ + nObjects_);
        SubList<vector>(exchange_, nNodes_) = force;
        forAll(meanPressure_, objecti)
        {
            exchange_[nNodes_ + objecti] =
                vector(meanPressure_[objecti], 0, 0);
        }
        sumOverRanks(exchange_);
        force = SubList<vector>(exchange_, nNodes_);
        forAll(meanPressure_, objecti)
        {
            meanPressure_[objecti] = exchange_[nNodes_ + objecti].x();
        }
    }
}


void Foam::fsi::wallOperator::addFluxLess
(
    const scalarField& net,
    const vectorField& v,
    scalarField& Jv
) const
{
    const scalarField netPerArea(net*perArea_);
    addFlux<BOTH>(netPerArea, v, Jv);
    addFlux<LOWER>(netPerArea, v, Jv);
    addFlux<UPPER>(netPerArea, v, Jv);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallOperator::addFluxAtWalls
(
    const vectorField& v,
    scalarField& Jv
) const
{
    // Net flux 1.J v of each object: no exchange, the nodes are on all ranks
    scalarField& net = meanPressure_;
    net = 0;
    forAll(uniformForce_, nodei)
    {
        net[pointObject_[nodei]] += uniformForce_[nodei] & v[nodei];
    }
    addFluxLess(net, v, Jv);
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
