// SPDX-License-Identifier: GPL-3.0-or-later

#include "newCells.H"
#include "fillFromNeighbours.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::fillNewCells
(
    const boolList& wasActive,
    const boolList& active,
    volScalarField& p
)
{
    scalarField known(p.size(), Zero);
    DynamicList<label> cells;
    forAll(wasActive, celli)
    {
        known[celli] = wasActive[celli] ? 1 : 0;
        if (active[celli] && !wasActive[celli])
        {
            cells.append(celli);
        }
    }
    fillFromNeighbours
    (
        p.mesh(),
        nullptr,
        cells,
        known,
        p.primitiveFieldRef()
    );
    p.correctBoundaryConditions();
}


// ************************************************************************* //
