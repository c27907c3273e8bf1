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
    entries_.addTransposed(p, force, meanPressure_);
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
        entries_.addFlux(v, net*perArea_, Jv);
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
    entries_.addFlux(heldVelocity_, net*perArea_, Jv);
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
    scalarField ofWalls(atWalls_.size(), Zero);
    entries_.addShares(givenFlux_*perArea_, ofWalls);
    forAll(ofWalls, at)
    {
        Jv[atWalls_.cells()[at]] += ofWalls[at];
    }
}


void Foam::fsi::wallOperator::addGrossFluxAtWalls
(
    const vectorField& v,
    scalarField& Jv
) const
{
    entries_.addFlux(v, scalarField(nObjects_, Zero), Jv);
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


void Foam::fsi::wallOperator::forFilmConductances
(
    const vectorField& mobility,
    const std::function<void(const label, const scalar)>& conducts
) const
{
    if (geometry_.films().faces().empty())
    {
        return;
    }
    filmConductance films(atWalls_.size());
    List<FixedList<label, 2>> cells(geometry_.films().faces().size());
    forAll(cells, i)
    {
        const filmFace& film = geometry_.films().faces()[i];
        cells[i] = geometry_.grid().cellsBeside(film.face);
        for (label& celli : cells[i])
        {
            celli = celli < 0 ? -1 : place(celli);
            if (celli >= 0)
            {
                films.addCell(celli);
            }
        }
    }
    entries_.addCarriers(films);
    filmFluxes_.addCarriers(films);
    forAll(cells, i)
    {
        if (cells[i][0] >= 0 && cells[i][1] >= 0)
        {
            conducts
            (
                geometry_.films().faces()[i].face,
                films.between(cells[i][0], cells[i][1], mobility)
            );
        }
    }
}


// ************************************************************************* //
