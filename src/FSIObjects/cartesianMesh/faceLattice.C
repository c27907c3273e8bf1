// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceLattice.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::faceLattice::faceLattice(const cartesianMesh& grid)
:
    grid_(grid)
{
    const cartesianBlock cells(grid.cells());
    lattice_.origin = grid.bounds().min();
    lattice_.spacing = grid.spacing();
    lattice_.nDims = grid.nDims();
    lattice_.all = grid.globalN();
    for (direction d = 0; d < 3; ++d)
    {
        lattice_.cyclic[d] = grid.period()[d] > 0;
    }
    lattice_.start = cells.start();
    lattice_.n = cells.n();
    setPlaces();
    setLines();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::faceLattice::setPlaces()
{
    const fvMesh& mesh = grid_.mesh();
    const cartesianBlock cells(grid_.cells());
    placeOfCell_.setSize(mesh.nCells());
    wraps_.setSize(mesh.nCells());
    forAll(placeOfCell_, celli)
    {
        const labelVector ijk
        (
            cells.ijk(grid_.blockIndex()[celli]) + cells.start()
        );
        placeOfCell_[celli] = lattice_.place(ijk);
        wraps_[celli] = 0;
        for (direction d = 0; d < grid_.nDims(); ++d)
        {
            const bool last =
                lattice_.cyclic[d] && lattice_.n[d] == lattice_.all[d]
             && ijk[d] == lattice_.start[d] + lattice_.n[d] - 1;
            wraps_[celli] |= last << d;
        }
    }

    place_.setSize(mesh.nFaces(), -1);
    mine_.setSize(mesh.nFaces(), false);
    grid_.forFaces([&](const label facei)
    {
        const label celli = mesh.faceOwner()[facei];
        const bool along = grid_.faceAlong(facei);
        place_[facei] = side(celli, grid_.faceDirection(facei), along);

        // On coupled patches the cell above the face has it
        const label patchi =
            facei < mesh.nInternalFaces()
          ? -1 : mesh.boundaryMesh().whichPatch(facei);
        mine_[facei] =
            patchi < 0 || !mesh.boundaryMesh()[patchi].coupled() || !along;
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::faceLattice::setVelocities
(
    const surfaceScalarField& phi,
    const surfaceScalarField& openArea,
    const volVectorField& U,
    faceArrays& u
) const
{
    setZero(u);
    const fvMesh& mesh = grid_.mesh();
    const scalar perArea = 1/grid_.faceArea();
    const auto set = [&]
    (
        const label facei,
        const scalar flux,
        const scalar open,
        const auto& mean
    )
    {
        if (mine_[facei])
        {
            const direction d = grid_.faceDirection(facei);
            const scalar velocity = perArea*flux;
            u[d][place_[facei]] =
                open < 1 - SMALL ? mean(d)
              : grid_.faceAlong(facei) ? velocity : -velocity;
        }
    };
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        set
        (
            facei,
            phi[facei],
            openArea[facei],
            [&](const direction d)
            {
                return 0.5*(U[own[facei]][d] + U[nei[facei]][d]);
            }
        );
    }
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        const vectorField value
        (
            pU.coupled()
          ? 0.5*(pU.patchInternalField() + pU.patchNeighbourField())
          : tmp<vectorField>(pU)
        );
        const fvsPatchScalarField& flux = phi.boundaryField()[patchi];
        forAll(flux, i)
        {
            set
            (
                pU.patch().start() + i,
                flux[i],
                openArea.boundaryField()[patchi][i],
                [&](const direction d) { return value[i][d]; }
            );
        }
    }
    setBeyond(U, u);
}


void Foam::fsi::faceLattice::setZero(faceArrays& values) const
{
    for (direction d = 0; d < lattice_.nDims; ++d)
    {
        values[d].setSize(lattice_.size());
        values[d] = Zero;
    }
}


// ************************************************************************* //
