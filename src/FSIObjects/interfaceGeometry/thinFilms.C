// SPDX-License-Identifier: GPL-3.0-or-later

#include "thinFilms.H"
#include "fetchAhead.H"
#include "levelSetUpdate.H"
#include "openfoamVersion.H"

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

bool Foam::fsi::thinFilms::isNarrow
(
    const label celli,
    scalar& change
) const
{
    const polyMesh& mesh = grid_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    // A side at a patch counts as open
    const scalarField& openness = open_.openness();
    const scalarField& last = open_.lastOpenness();
    scalar open = 0;
    change = 0;
    for (const label facei : mesh.cells()[celli])
    {
        const bool internal = mesh.isInternalFace(facei);
        if (!internal && grid_.faceCorners().first()[facei] < 0)
        {
            continue;
        }
        if (internal || patches[patches.whichPatch(facei)].coupled())
        {
            open += openness[facei];
            change += mag(openness[facei] - last[facei]);
        }
        else
        {
            open += 1;
        }
    }
    change /= open;
    return open < grid_.nDims();
}


Foam::labelList Foam::fsi::thinFilms::halfClosedCells
(
    const UList<wallFace>& wallFaces
)
{
    const scalarField& openness = open_.openness();
    DynamicList<label> touched(wallFaces.size());
    forAll(wallFaces, i)
    {
        fetchAhead(openness[fetchedAhead(wallFaces, i).face]);
        const wallFace& w = wallFaces[i];
        const scalar closed =
            w.film ? w.area/grid_.faceArea() : 1 - openness[w.face];
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0)
            {
                if (closedSides_[celli] == 0)
                {
                    touched.append(celli);
                }
                closedSides_[celli] += closed;
            }
        }
    }

    // At least half of the sides of a cell in a film are closed
    DynamicList<label> found;
    for (const label celli : touched)
    {
        if (closedSides_[celli] > grid_.nDims() - ROOTSMALL)
        {
            found.append(celli);
        }
        closedSides_[celli] = 0;
    }
    sort(found);
    return labelList(std::move(found));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::thinFilms::thinFilms(const openParts& open)
:
    grid_(open.grid()),
    open_(open),
    closedSides_(grid_.mesh().nCells(), 0),
    atPatch_(grid_.mesh().nCells(), false),
    change_
    (
        IOobject
        (
            "filmChange",
            nameOf(grid_.mesh().time()),
            grid_.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        grid_.mesh(),
        dimensionedScalar("value", dimless, 0)
    )
{
    for (const polyPatch& patch : grid_.mesh().boundaryMesh())
    {
        if (!patch.coupled() && !isA<emptyPolyPatch>(patch))
        {
            UIndirectList<bool>(atPatch_, patch.faceCells()) = true;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::thinFilms::update
(
    const levelSetUpdate& levelSet,
    const UList<wallFace>& wallFaces
)
{
    const scalarField& distance = levelSet.cellDistance();
    const cartesianBlock halo(grid_.cells(1));

    for (const label celli : cells_)
    {
        change_[celli] = 0;
    }
    cells_.clear();
    const scalar diagonal =
        0.5*sqrt(scalar(grid_.nDims()))*grid_.spacing();
    for (const label celli : halfClosedCells(wallFaces))
    {
        const label here = grid_.haloIndex()[celli];
        scalar change;
        if
        (
            distance[here] < diagonal
         && (
                atPatch_[celli]
             || slopeDrop(halo, grid_.nDims(), distance, here) > leastDrop
            )
         && isNarrow(celli, change)
        )
        {
            cells_.append(celli);
            if (!open_.first())
            {
                // In the first step change_ may come from a restart
                change_[celli] = min(change/fastest, 1.0);
            }
        }
    }
}


// ************************************************************************* //
