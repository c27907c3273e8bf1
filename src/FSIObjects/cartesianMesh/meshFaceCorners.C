// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshFaceCorners.H"
#include "cartesianMesh.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::meshFaceCorners::set(const cartesianMesh& grid)
{
    const fvMesh& mesh = grid.mesh();
    const cartesianBlock block(grid.corners());
    const point origin(grid.bounds().min());
    nDims_ = grid.nDims();
    stride_ = labelVector(block.stride(0), block.stride(1), block.stride(2));
    first_.setSize(mesh.nFaces());
    first_ = -1;
    forAll(first_, facei)
    {
        if (grid.faceDirection(facei) >= nDims_)
        {
            continue;
        }
        label lowest = labelMax;
        for (const label pointi : mesh.faces()[facei])
        {
            labelVector ijk(0, 0, 0);
            for (direction d = 0; d < nDims_; ++d)
            {
                const scalar s = mesh.points()[pointi][d] - origin[d];
                ijk[d] = label(round(s/grid.spacing()));
            }
            lowest = min(lowest, block.index(ijk - block.start()));
        }
        first_[facei] = lowest;
    }
}


// ************************************************************************* //
