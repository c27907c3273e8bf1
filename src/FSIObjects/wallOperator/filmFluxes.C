// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmFluxes.H"
#include "sumOverRanks.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::filmFluxes::add
(
    const filmFace& film,
    const filmSide& side,
    const vector& area,
    const FixedList<label, 2>& cells
)
{
    if (side.isWall())
    {
        return;
    }
    side.place.forPairs
    (
        [&](const label a, const scalar u, const label b, const scalar v)
        {
            parts_.append({film.face, cells[0], cells[1], a, b, u, v, area});
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmFluxes::filmFluxes(const interfaceGeometry& geometry)
:
    geometry_(geometry)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmFluxes::update
(
    const labelUList& place,
    const scalar tau,
    const scalar viscosity
)
{
    const cartesianMesh& grid = geometry_.grid();
    parts_.clear();
    for (const filmFace& film : geometry_.films().faces())
    {
        const scalar kept = geometry_.films().kept(film.face, tau, viscosity);
        const scalar area =
            (1 - kept)*geometry_.openness()[film.face]*grid.faceArea();
        FixedList<label, 2> cells(grid.cellsBeside(film.face));
        for (label& celli : cells)
        {
            celli = celli < 0 ? -1 : place[celli];
        }

        // Surfaces that open push, seen from the mean of both
        vector atFace(Zero);
        forAll(film.ends, k)
        {
            const scalar push =
                area*film.perOpening*film.profile[k + 1]
               /max(film.profile[0], VSMALL);
            const filmEnd& end = film.ends[k];
            for (label i = 0; i < 2 && push != 0; ++i)
            {
                add(film, end.sides[i], push*end.normals[i], cells);
                atFace -= 0.5*push*end.normals[i];
            }
        }
        vector axis(Zero);
        axis[film.dir] = area;
        add(film, film.sides[0], (1 - film.middle)*axis + atFace, cells);
        add(film, film.sides[1], film.middle*axis + atFace, cells);
    }
}


void Foam::fsi::filmFluxes::addFlux
(
    const vectorField& v,
    scalarField& atWalls
) const
{
    for (const carried& w : parts_)
    {
        const scalar flux = w.flux(v);
        if (w.lower >= 0)
        {
            atWalls[w.lower] += flux;
        }
        if (w.upper >= 0)
        {
            atWalls[w.upper] -= flux;
        }
    }
}


void Foam::fsi::filmFluxes::addForce
(
    const scalarField& p,
    vectorField& f
) const
{
    for (const carried& w : parts_)
    {
        const scalar lower = w.lower >= 0 ? p[w.lower] : 0;
        const scalar upper = w.upper >= 0 ? p[w.upper] : 0;
        const vector load((lower - upper)*w.area);
        f[w.nodeA] += w.weightA*load;
        f[w.nodeB] += w.weightB*load;
    }
}


void Foam::fsi::filmFluxes::addCarriers(filmConductance& films) const
{
    for (const carried& w : parts_)
    {
        films.addCarrier(w.lower, w.nodeA, w.weightA*w.area);
        films.addCarrier(w.lower, w.nodeB, w.weightB*w.area);
        films.addCarrier(w.upper, w.nodeA, -w.weightA*w.area);
        films.addCarrier(w.upper, w.nodeB, -w.weightB*w.area);
    }
}


void Foam::fsi::filmFluxes::addFaceFlux
(
    const vectorField& v,
    surfaceScalarField& phi
) const
{
    const label nInternal = phi.mesh().nInternalFaces();
    scalarField onBoundary;
    setZeroOnCoupled(phi.mesh(), onBoundary);
    for (const carried& w : parts_)
    {
        const scalar along = w.flux(v);
        const scalar flux =
            geometry_.grid().faceAlong(w.face) ? along : -along;
        if (w.face < nInternal)
        {
            phi[w.face] += flux;
        }
        else
        {
            onBoundary[w.face - nInternal] += 0.5*flux;
        }
    }
    if (!severalRanks() && !geometry_.grid().coupled())
    {
        return;
    }
    scalarList across;
    swapCoupledFaces(phi.mesh(), onBoundary, across);
    for (fvsPatchScalarField& pp : phi.boundaryFieldRef())
    {
        for (label i = 0; i < pp.size() && pp.coupled(); ++i)
        {
            const label facei = pp.patch().start() + i - nInternal;
            pp[i] += onBoundary[facei] - across[facei];
        }
    }
}


// ************************************************************************* //
