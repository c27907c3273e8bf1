// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmPressure.H"
#include "fillFromNeighbours.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Passes from cell to cell at most: further inside a film any pressure of
//  its ends will do
constexpr Foam::label maxPasses = 8;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::fillFilmCells
(
    const interfaceGeometry& geometry,
    volScalarField& p
)
{
    const UList<label>& films = geometry.filmCells();
    const scalarField last(p.primitiveField(), films);
    DynamicList<label> cells(films);
    label left = overRanks(cells.size(), sumOp<label>());
    if (left == 0)
    {
        return;
    }

    scalarField known(p.size(), Zero);
    forAll(known, celli)
    {
        known[celli] = geometry.activeCell()[celli] ? 1 : 0;
    }
    for (const label celli : cells)
    {
        known[celli] = 0;
    }
    const scalar sum =
        overRanks(Foam::sum(known*p.primitiveField()), sumOp<scalar>());
    const scalar mean =
        sum/max(overRanks(Foam::sum(known), sumOp<scalar>()), 1.0);

    for (label pass = 0; pass < maxPasses && left > 0; ++pass)
    {
        left = fillFromNeighbours
        (
            p.mesh(), &geometry.openness(), cells, known, p.primitiveFieldRef()
        );
    }
    for (const label celli : cells)
    {
        p[celli] = mean;
    }
    forAll(films, i)
    {
        const label celli = films[i];
        p[celli] += (1 - geometry.filmChange()[celli])*(last[i] - p[celli]);
    }
    p.correctBoundaryConditions();
}


// ************************************************************************* //
