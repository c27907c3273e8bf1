// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmPressure.H"
#include "activeMean.H"
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

    boolList others(geometry.activeCell());
    for (const label celli : cells)
    {
        others[celli] = false;
    }
    const scalar mean = activeMean(p.primitiveField(), others);
    scalarField known(p.size());
    forAll(known, celli)
    {
        known[celli] = others[celli];
    }

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
