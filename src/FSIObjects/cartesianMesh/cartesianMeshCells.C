// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMesh.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cartesianMesh::setCoupledFaces()
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; i < patch.size() && patch.coupled(); ++i)
        {
            const label facei = patch.start() + i;
            coupledFaces_.insert
            (
                side
                (
                    patch.faceCells()[i],
                    faceDirection_[facei],
                    faceAlong_[facei]
                ),
                facei - mesh_.nInternalFaces()
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::cartesianMesh::findCell(const point& p) const
{
    labelVector ijk(0, 0, 0);
    for (direction dir = 0; dir < nDims_; ++dir)
    {
        ijk[dir] = label(floor((p[dir] - origin_[dir])/spacing_));
        if (period_[dir] > 0)
        {
            // Modulus that is >= 0
            const label n = globalN_[dir];
            ijk[dir] = (ijk[dir] % n + n) % n;
        }
    }
    const cartesianBlock block(cells(1));
    ijk -= block.start();
    return block.contains(ijk) ? cellAt_[block.index(ijk)] : -1;
}


Foam::label Foam::fsi::cartesianMesh::nextCell
(
    const label celli,
    const direction dir,
    const bool upwards
) const
{
    const label stride = haloStride_[dir];
    const label next =
        cellAt_[haloIndex_[celli] + (upwards ? stride : -stride)];
    if (next >= 0 || coupledFaces_.empty())
    {
        return next;
    }
    const label* face = findIn(coupledFaces_, side(celli, dir, upwards));
    return face ? -2 - *face : -1;
}


// ************************************************************************* //
