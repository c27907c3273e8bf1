// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceGeometry.H"
#include "wallTreatment.H"
#include "levelSetUpdate.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Faces open by less than this are closed
static const scalar smallestOpenness = 1e-6;

//- A face whose owner is farther from the surfaces, in cells, is open or closed
//  as a whole, and so are those next to it: less than the band's least width
static const scalar nearest = 2.5;

//- Values per mesh face as a surface field; empty faces are left out
static void setSurfaceField
(
    surfaceScalarField& field,
    const scalarField& perFace
)
{
    const fvMesh& mesh = field.mesh();
    field.primitiveFieldRef() =
        SubField<scalar>(perFace, mesh.nInternalFaces());

    for (fvsPatchField<scalar>& pf : field.boundaryFieldRef())
    {
        const label start = pf.patch().start();
        forAll(pf, i)
        {
            pf[i] = perFace[start + i];
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::interfaceGeometry::acrossFace
(
    const label facei,
    const direction dir
) const
{
    const fvMesh& mesh = grid_.mesh();
    const label stride = grid_.cells(1).stride(dir);
    const label own = haloIndex_[mesh.faceOwner()[facei]];
    return grid_.faceAlong(facei) ? own + stride : own - stride;
}


void Foam::fsi::interfaceGeometry::setOpenness(const levelSetUpdate& levelSet)
{
    const fvMesh& mesh = grid_.mesh();
    const scalarField& cellDistance = levelSet.cellDistance();
    const scalarField& cornerDistance = levelSet.cornerDistance();
    const label nCorners = grid_.nDims() == 2 ? 2 : 4;
    const scalar reach = nearest*grid_.spacing();

    nearFaces_.clear();
    grid_.forFaces([&](const label facei)
    {
        const scalar inCell = cellDistance[haloIndex_[mesh.faceOwner()[facei]]];
        if (mag(inCell) > reach)
        {
            // All corners are on the same side
            openness_[facei] = inCell > 0 ? 1 : 0;
            return;
        }
        nearFaces_.append(facei);
        const FixedList<label, 4>& corners = grid_.faceCorners(facei);
        FixedList<scalar, 4> distance(Zero);
        for (label i = 0; i < nCorners; ++i)
        {
            distance[i] = cornerDistance[corners[i]];
        }

        const scalar open = wall_.openness
        (
            distance,
            nCorners,
            inCell,
            cellDistance[acrossFace(facei, grid_.faceDirection(facei))]
        );
        openness_[facei] = open < smallestOpenness ? 0 : open;
    });

    // On cyclic patches the distances of both sides differ by round-off
    SubList<scalar> boundary
    (
        openness_,
        mesh.nFaces() - mesh.nInternalFaces(),
        mesh.nInternalFaces()
    );
    syncTools::syncBoundaryFaceList(mesh, boundary, minEqOp<scalar>());
}


void Foam::fsi::interfaceGeometry::setCells(const levelSetUpdate& levelSet)
{
    const polyMesh& mesh = grid_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const scalarField& distance = levelSet.cellDistance();

    // More than a cell's diagonal from the surfaces all sides are open
    const scalar h = grid_.spacing();
    forAll(activeCell_, celli)
    {
        activeCell_[celli] = fluidCell_[celli] =
            distance[haloIndex_[celli]] > h;
    }
    const auto activate = [&](const label celli)
    {
        activeCell_[celli] = true;
        fluidCell_[celli] = distance[haloIndex_[celli]] > 0;
    };
    for (const label facei : nearFaces_)
    {
        const bool internal = mesh.isInternalFace(facei);
        if
        (
            openness_[facei] > 0
         && (internal || patches[patches.whichPatch(facei)].coupled())
        )
        {
            activate(mesh.faceOwner()[facei]);
            if (internal)
            {
                activate(mesh.faceNeighbour()[facei]);
            }
        }
    }
}


void Foam::fsi::interfaceGeometry::setFields(const boolList& across)
{
    setSurfaceField(openArea_, openness_);

    // Both cells fluid; those across are judged by their owners
    const fvMesh& mesh = grid_.mesh();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        fluidFace_[facei] = fluidCell_[own[facei]] && fluidCell_[nei[facei]];
    }
    for (fvsPatchScalarField& pf : fluidFace_.boundaryFieldRef())
    {
        const labelUList& cells = pf.patch().faceCells();
        const label first = pf.patch().start() - mesh.nInternalFaces();
        forAll(pf, i)
        {
            pf[i] = fluidCell_[cells[i]] && across[first + i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::interfaceGeometry::interfaceGeometry
(
    const cartesianMesh& grid,
    const wallTreatment& wall
)
:
    grid_(grid),
    wall_(wall),
    haloIndex_(grid.mesh().nCells()),
    openness_(grid.mesh().nFaces(), 1),
    closedSides_(grid.mesh().nCells(), 0),
    fluidCell_(grid.mesh().nCells(), true),
    activeCell_(grid.mesh().nCells(), true),
    filmChange_
    (
        IOobject
        (
            "filmChange",
            grid.mesh().time().timeName(),
            grid.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        grid.mesh(),
        dimensionedScalar("value", dimless, 0)
    ),
    cellWalls_(grid.mesh().nCells()),
    openArea_
    (
        IOobject("openArea", grid.mesh().time().timeName(), grid.mesh()),
        grid.mesh(),
        dimensionedScalar("value", dimless, 1)
    ),
    fluidFace_
    (
        IOobject("fluidFace", grid.mesh().time().timeName(), grid.mesh()),
        grid.mesh(),
        dimensionedScalar("value", dimless, 1)
    )
{
    const cartesianBlock block(grid.cells());
    const cartesianBlock halo(grid.cells(1));
    const labelVector shift(1, 1, grid.nDims() == 3 ? 1 : 0);
    forAll(haloIndex_, celli)
    {
        haloIndex_[celli] =
            halo.index(block.ijk(grid.blockIndex()[celli]) + shift);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::interfaceGeometry::update
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const bool first = lastOpenness_.empty();
    if (!first)
    {
        lastOpenness_.swap(openness_);
    }
    setOpenness(levelSet);
    if (first)
    {
        lastOpenness_ = openness_;
    }
    setCells(levelSet);
    setFilmCells(levelSet, first);
    boolList across;
    swapCoupledCells(grid_.mesh(), fluidCell_, across);
    setFields(across);
    setWallFaces(levelSet, surfaces);
    cellWalls_.update(surfaces, wallFaces_, wallOrigins_);
    setOpenFaces(levelSet, across);
    setWallLinks(levelSet, surfaces);
    setInnerFaces(across);
    setOutsideWalls(levelSet, surfaces);
}


// ************************************************************************* //
