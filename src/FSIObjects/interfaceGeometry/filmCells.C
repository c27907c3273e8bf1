// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceGeometry.H"
#include "emptyPolyPatch.H"
#include "levelSetUpdate.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Between two surfaces the slope of the distance changes its sign: least
//  drop of the slope from one side of the cell to the other. Across a thin film
//  it is 1 to 2, a single surface has h over its radius.
static const scalar leastDrop = 0.5;

//- A film changes fast if its open parts change by this part in a step
static const scalar fastest = 0.02;


//- Largest drop of the slope of the distance at a sample, of all directions to
//  its neighbours and their diagonals
static scalar slopeDrop
(
    const cartesianBlock& block,
    const label nDims,
    const scalarField& distance,
    const label here
)
{
    scalar drop = 0;
    for (label k = (nDims > 2 ? -1 : 0); k <= (nDims > 2 ? 1 : 0); ++k)
    {
        for (label j = -1; j <= 1; ++j)
        {
            // The other half are the same directions
            for (label i = 0; i <= 1; ++i)
            {
                const scalar length = sqrt(scalar(i*i + j*j + k*k));
                const label step =
                    i*block.stride(0) + j*block.stride(1) + k*block.stride(2);
                drop = max
                (
                    drop,
                    (
                        2*distance[here]
                      - distance[here + step]
                      - distance[here - step]
                    )/max(length, scalar(1))
                );
            }
        }
    }
    return drop/block.spacing();
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::interfaceGeometry::sumOpenParts
(
    scalarField& open,
    scalarField& change,
    boolList& atPatch
) const
{
    const polyMesh& mesh = grid_.mesh();
    open.setSize(mesh.nCells());
    open = Zero;
    change.setSize(mesh.nCells());
    change = Zero;
    atPatch.setSize(mesh.nCells());
    atPatch = false;

    const auto add = [&](const label celli, const label facei)
    {
        open[celli] += openness_[facei];
        change[celli] += mag(openness_[facei] - lastOpenness_[facei]);
    };
    forAll(mesh.faceNeighbour(), facei)
    {
        add(mesh.faceOwner()[facei], facei);
        add(mesh.faceNeighbour()[facei], facei);
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            continue;
        }
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            if (patch.coupled())
            {
                add(celli, patch.start() + i);
            }
            else
            {
                open[celli] += 1;
                atPatch[celli] = true;
            }
        }
    }
}


void Foam::fsi::interfaceGeometry::setFilmCells
(
    const levelSetUpdate& levelSet,
    const bool first
)
{
    const scalarField& distance = levelSet.cellDistance();
    const cartesianBlock halo(grid_.cells(1));
    scalarField open, change;
    boolList atPatch;
    sumOpenParts(open, change, atPatch);

    for (const label celli : filmCells_)
    {
        filmChange_[celli] = 0;
    }
    filmCells_.clear();
    forAll(open, celli)
    {
        if (!activeCell_[celli] || open[celli] >= grid_.nDims())
        {
            continue;
        }
        if
        (
            atPatch[celli]
         || slopeDrop(halo, grid_.nDims(), distance, haloIndex_[celli])
          > leastDrop
        )
        {
            filmCells_.append(celli);
            if (!first)
            {
                filmChange_[celli] =
                    min(change[celli]/(fastest*open[celli]), 1.0);
            }
        }
    }
}


// ************************************************************************* //
