// SPDX-License-Identifier: GPL-3.0-or-later

#include "narrowCells.H"
#include "emptyPolyPatch.H"
#include "syncTools.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Passes from cell to cell at most: further inside a film any pressure of
//  its ends will do
constexpr label maxPasses = 8;


//- An open face of a narrow cell
struct opening
{
    label cell;

    //- Cell on the other side, or -1 - the coupled face, counted from the
    //  first boundary face
    label other;

    scalar area;
};


//- Calls visit(cell, other, openness) for both sides of every open face
template<class Visitor>
void visitOpenings(const fsi::interfaceGeometry& geometry, Visitor visit)
{
    const polyMesh& mesh = geometry.grid().mesh();
    const scalarField& open = geometry.openness();
    const labelUList& owner = mesh.faceOwner();
    const labelUList& neighbour = mesh.faceNeighbour();

    forAll(neighbour, facei)
    {
        if (open[facei] > 0)
        {
            visit(owner[facei], neighbour[facei], open[facei]);
            visit(neighbour[facei], owner[facei], open[facei]);
        }
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                const label other = -1 - (facei - mesh.nInternalFaces());
                if (open[facei] > 0)
                {
                    visit(owner[facei], other, open[facei]);
                }
            }
        }
    }
}


//- Active cells open by less than half; a side at a patch counts as open
boolList findNarrow(const fsi::interfaceGeometry& geometry)
{
    const polyMesh& mesh = geometry.grid().mesh();
    scalarField sum(mesh.nCells(), Zero);
    visitOpenings
    (
        geometry,
        [&](const label celli, const label, const scalar area)
        {
            sum[celli] += area;
        }
    );
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!patch.coupled() && !isA<emptyPolyPatch>(patch))
        {
            for (const label celli : patch.faceCells())
            {
                sum[celli] += 1;
            }
        }
    }

    const scalar half = geometry.grid().nDims();
    boolList narrow(mesh.nCells());
    forAll(narrow, celli)
    {
        narrow[celli] = geometry.activeCell()[celli] && sum[celli] < half;
    }
    return narrow;
}


//- Fill the cells that have a known neighbour; the number still unknown, of
//  all ranks
label fillOnce
(
    const polyMesh& mesh,
    const UList<opening>& openings,
    scalarField& known,
    scalarField& p
)
{
    scalarList coupledKnown, coupledP;
    syncTools::swapBoundaryCellList(mesh, known, coupledKnown);
    syncTools::swapBoundaryCellList(mesh, p, coupledP);

    scalarField weight(openings.size(), Zero), sum(openings.size(), Zero);
    label left = 0;
    for (label i = 0; i < openings.size();)
    {
        const label first = i;
        const label celli = openings[first].cell;
        for (; i < openings.size() && openings[i].cell == celli; ++i)
        {
            const label other = openings[i].other;
            const scalar a =
                openings[i].area
               *(other < 0 ? coupledKnown[-1 - other] : known[other]);
            weight[first] += a;
            sum[first] += a*(other < 0 ? coupledP[-1 - other] : p[other]);
        }
        left += known[celli] < 0.5 && weight[first] <= 0;
    }
    forAll(openings, i)
    {
        const label celli = openings[i].cell;
        if (weight[i] > 0 && known[celli] < 0.5)
        {
            p[celli] = sum[i]/weight[i];
            known[celli] = 1;
        }
    }
    return returnReduce(left, sumOp<label>());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::fillNarrowCells
(
    const interfaceGeometry& geometry,
    volScalarField& p
)
{
    const boolList narrow(findNarrow(geometry));

    DynamicList<opening> openings;
    visitOpenings
    (
        geometry,
        [&](const label celli, const label other, const scalar area)
        {
            if (narrow[celli])
            {
                openings.append(opening{celli, other, area});
            }
        }
    );
    if (returnReduce(openings.empty(), andOp<bool>()))
    {
        return;
    }
    std::stable_sort
    (
        openings.begin(),
        openings.end(),
        [](const opening& a, const opening& b) { return a.cell < b.cell; }
    );

    // Mean pressure of the others, for films that no opening leads to
    scalarField known(narrow.size(), Zero);
    scalar sum = 0, count = 0;
    forAll(known, celli)
    {
        if (geometry.activeCell()[celli] && !narrow[celli])
        {
            known[celli] = 1;
            sum += p[celli];
            count += 1;
        }
    }
    reduce(sum, sumOp<scalar>());
    reduce(count, sumOp<scalar>());
    const scalar mean = sum/max(count, scalar(1));

    label left = 1;
    for (label pass = 0; pass < maxPasses && left > 0; ++pass)
    {
        left = fillOnce
        (
            geometry.grid().mesh(), openings, known, p.primitiveFieldRef()
        );
    }
    forAll(narrow, celli)
    {
        if (narrow[celli] && known[celli] < 0.5)
        {
            p[celli] = mean;
        }
    }
    p.correctBoundaryConditions();
}


// ************************************************************************* //
