// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallEntries.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallEntries::update
(
    const interfaceGeometry& geometry,
    const cellsAtWalls& atWalls,
    scalarField& areas
)
{
    entries_.clear();
    for (const cellWall& w : geometry.surfaceParts())
    {
        const scalar area = mag(w.area);
        areas[w.place.object] += area;
        w.place.forPairs
        (
            [&](const label a, const scalar u, const label b, const scalar v)
            {
                entries_.append
                ({
                    atWalls.places()[w.cell],
                    w.place.object,
                    a,
                    b,
                    u,
                    v,
                    area*(u + v),
                    w.area
                });
            }
        );
    }
}


void Foam::fsi::wallEntries::addTransposed
(
    const scalarField& p,
    vectorField& force,
    scalarField& sums
) const
{
    for (const entry& w : entries_)
    {
        const vector load(p[w.cell]*w.area);
        force[w.nodeA] += w.weightA*load;
        force[w.nodeB] += w.weightB*load;
        sums[w.object] += w.share*p[w.cell];
    }
}


void Foam::fsi::wallEntries::addFlux
(
    const vectorField& v,
    const scalarField& perArea,
    scalarField& Jv
) const
{
    for (const entry& w : entries_)
    {
        Jv[w.cell] +=
            (w.area & (w.weightA*v[w.nodeA] + w.weightB*v[w.nodeB]))
          - w.share*perArea[w.object];
    }
}


void Foam::fsi::wallEntries::addShares
(
    const scalarField& perArea,
    scalarField& Jv
) const
{
    for (const entry& w : entries_)
    {
        Jv[w.cell] += w.share*perArea[w.object];
    }
}


void Foam::fsi::wallEntries::addCarriers(filmConductance& films) const
{
    for (const entry& w : entries_)
    {
        films.addCarrier(w.cell, w.nodeA, w.weightA*w.area);
        films.addCarrier(w.cell, w.nodeB, w.weightB*w.area);
    }
}


// ************************************************************************* //
