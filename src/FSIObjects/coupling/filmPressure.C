// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmPressure.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Passes from cell to cell at most: further inside a film any pressure of
//  its ends will do
constexpr label maxPasses = 8;


//- Mean over the neighbours that are known of a cell, weighted by the open
//  parts of the faces; false if there is none. coupledKnown, coupledP: of the
//  cells across coupled faces, from the first boundary face.
bool meanOfKnown
(
    const fsi::interfaceGeometry& geometry,
    const label celli,
    const scalarField& known,
    const scalarList& coupledKnown,
    const scalarField& p,
    const scalarList& coupledP,
    scalar& mean
)
{
    const polyMesh& mesh = geometry.grid().mesh();
    scalar weight = 0, sum = 0;
    for (const label facei : mesh.cells()[celli])
    {
        const label outside = facei - mesh.nInternalFaces();
        const scalar open = geometry.openness()[facei];
        if (outside < 0)
        {
            const label own = mesh.faceOwner()[facei];
            const label other =
                own == celli ? mesh.faceNeighbour()[facei] : own;
            weight += open*known[other];
            sum += open*known[other]*p[other];
        }
        else
        {
            weight += open*coupledKnown[outside];
            sum += open*coupledKnown[outside]*coupledP[outside];
        }
    }
    mean = sum/max(weight, VSMALL);
    return weight > 0;
}


//- Fill the cells that have a known neighbour, and take them from the list.
//  Returns how many are left on all ranks.
label fillOnce
(
    const fsi::interfaceGeometry& geometry,
    DynamicList<label>& cells,
    scalarField& known,
    scalarField& p
)
{
    const polyMesh& mesh = geometry.grid().mesh();
    scalarList coupledKnown, coupledP;
    syncTools::swapBoundaryCellList(mesh, known, coupledKnown);
    syncTools::swapBoundaryCellList(mesh, p, coupledP);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!patch.coupled())
        {
            const label start = patch.start() - mesh.nInternalFaces();
            SubList<scalar>(coupledKnown, patch.size(), start) = Zero;
        }
    }

    DynamicList<label> filled, left;
    DynamicList<scalar> values;
    for (const label celli : cells)
    {
        scalar mean;
        if
        (
            meanOfKnown
            (
                geometry, celli, known, coupledKnown, p, coupledP, mean
            )
        )
        {
            filled.append(celli);
            values.append(mean);
        }
        else
        {
            left.append(celli);
        }
    }
    forAll(filled, i)
    {
        p[filled[i]] = values[i];
        known[filled[i]] = 1;
    }
    cells.transfer(left);
    return returnReduce(cells.size(), sumOp<label>());
}

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
    label left = returnReduce(cells.size(), sumOp<label>());
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
    const scalar mean = gSum(known*p.primitiveField())/max(gSum(known), 1.0);

    for (label pass = 0; pass < maxPasses && left > 0; ++pass)
    {
        left = fillOnce(geometry, cells, known, p.primitiveFieldRef());
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
