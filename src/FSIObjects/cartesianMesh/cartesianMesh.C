// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMesh.H"
#include "domainSides.H"
#include "sumOverRanks.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Folder of the mesh's files
static fileName meshFolder(const fvMesh& mesh)
{
    return mesh.time().path()/mesh.pointsInstance()/mesh.meshDir();
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cartesianMesh::refuse
(
    const label celli,
    const string& reason
) const
{
    FatalErrorInFunction
        << "Mesh " << meshFolder(mesh_) << " is not uniform Cartesian: "
        << reason.c_str() << nl
        << "    cell " << celli << " with centre " << mesh_.C()[celli]
        << " and volume " << mesh_.V()[celli] << nl
        << "    All cells must be squares (2D, one cell thick in z) or cubes"
        << " (3D) of size " << spacing_ << "; use blockMesh without grading"
        << nl << "    They must fill the whole box of the mesh; steps and"
        << " obstacles are objects with motion { type fixed; }"
        << exit(FatalError);
}


void Foam::fsi::cartesianMesh::setSpacing()
{
    const Vector<label>& d = mesh_.geometricD();
    if (d.x() != 1 || d.y() != 1)
    {
        FatalErrorInFunction
            << "Mesh " << meshFolder(mesh_) << " must be solved in x and"
            << " y (and z in 3D) but its geometric directions are " << d
            << exit(FatalError);
    }

    nDims_ = d.z() == 1 ? 3 : 2;

    const boundBox bb(mesh_.bounds());
    thickness_ = nDims_ == 2 ? bb.span().z() : 1;
    origin_ = bb.min();

    const label nCells = overRanks(mesh_.nCells(), sumOp<label>());
    const scalar cellVolume =
        bb.volume()/(thickness_*max(nCells, 1));
    const scalar guess =
        nDims_ == 2 ? Foam::sqrt(cellVolume) : Foam::cbrt(cellVolume);

    for (direction dir = 0; dir < 3; ++dir)
    {
        globalN_[dir] =
            dir < nDims_ ? max(label(round(bb.span()[dir]/guess)), 1) : 1;
    }
    spacing_ = bb.span().x()/globalN_.x();
}


void Foam::fsi::cartesianMesh::setIndices()
{
    const vectorField& C = mesh_.C();
    const scalarField& V = mesh_.V();
    const scalar tolerance = 1e-5*spacing_;
    const scalar volume = pow(spacing_, nDims_)*thickness_;

    List<labelVector> ijk(C.size(), Zero);
    labelVector lower(labelMax, labelMax, labelMax);
    labelVector upper(labelMin, labelMin, labelMin);

    forAll(C, celli)
    {
        for (direction dir = 0; dir < nDims_; ++dir)
        {
            const scalar s = (C[celli][dir] - origin_[dir])/spacing_ - 0.5;
            ijk[celli][dir] = label(round(s));
            if (mag(s - ijk[celli][dir])*spacing_ > tolerance)
            {
                refuse(celli, "its centre is off the lattice");
            }
        }
        if (mag(V[celli] - volume) > 1e-4*volume)
        {
            refuse(celli, "its volume differs");
        }
        lower = min(lower, ijk[celli]);
        upper = max(upper, ijk[celli]);
    }

    start_ = C.empty() ? labelVector(0, 0, 0) : lower;
    n_ = C.empty() ? labelVector(0, 0, 0) : upper - lower + labelVector::one;

    const cartesianBlock block(cells());
    blockIndex_.setSize(C.size());
    const cartesianBlock halo(cells(1));
    haloIndex_.setSize(C.size());
    cellAt_.setSize(halo.size());
    cellAt_ = -1;
    forAll(C, celli)
    {
        blockIndex_[celli] = block.index(ijk[celli] - start_);
        haloIndex_[celli] = halo.index(ijk[celli] - halo.start());
        cellAt_[haloIndex_[celli]] = celli;
    }
    haloStride_ = labelVector(halo.stride(0), halo.stride(1), halo.stride(2));
}


void Foam::fsi::cartesianMesh::setFaceDirections()
{
    faceDirection_.setSize(mesh_.nFaces());
    faceAlong_.setSize(mesh_.nFaces());
    forAll(faceDirection_, facei)
    {
        const vector& area = mesh_.faceAreas()[facei];
        const vector S(cmptMag(area));
        if
        (
            (nDims_ == 3 || S.z() <= 0.5*mag(S))
         && (
                cmptMax(S) < (1 - 1e-6)*mag(S)
             || mag(mag(S) - faceArea()) > 1e-4*faceArea()
            )
        )
        {
            const label celli = mesh_.faceOwner()[facei];
            refuse(celli, "one of its faces is skewed or stretched");
        }
        const direction d =
            S.x() > S.y() && S.x() > S.z() ? 0 : S.y() > S.z() ? 1 : 2;
        faceDirection_[facei] = d;
        faceAlong_[facei] = area[d] > 0;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianMesh::cartesianMesh(const fvMesh& mesh)
:
    mesh_(mesh),
    period_(domainSides(mesh).period())
{
    setSpacing();
    setIndices();
    setFaceDirections();
    setCoupledFaces();
    faceCorners_.set(*this);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::fsi::cartesianMesh::bounds() const
{
    return mesh_.bounds();
}


Foam::fsi::cartesianBlock Foam::fsi::cartesianMesh::centres
(
    const labelVector& start,
    const labelVector& n,
    const label halo
) const
{
    const vector half(0.5*spacing_, 0.5*spacing_, 0.5*spacing_);
    point first(origin_ + half);
    labelVector grown(halo, halo, halo);
    if (nDims_ == 2)
    {
        first.z() = origin_.z() + 0.5*thickness_;
        grown.z() = 0;
    }
    return cartesianBlock
    (
        first,
        spacing_,
        n + grown + grown,
        nDims_,
        start - grown
    );
}


Foam::fsi::cartesianBlock Foam::fsi::cartesianMesh::cells
(
    const label halo
) const
{
    return centres(start_, n_, halo);
}


Foam::fsi::cartesianBlock Foam::fsi::cartesianMesh::globalCells
(
    const label halo
) const
{
    return centres(labelVector(0, 0, 0), globalN_, halo);
}


Foam::fsi::cartesianBlock Foam::fsi::cartesianMesh::corners() const
{
    point first(origin_);
    labelVector n(n_ + labelVector::one);
    if (nDims_ == 2)
    {
        first.z() = origin_.z() + 0.5*thickness_;
        n.z() = 1;
    }
    return cartesianBlock(first, spacing_, n, nDims_, start_);
}


// ************************************************************************* //
