// SPDX-License-Identifier: GPL-3.0-or-later

#include "domainSides.H"
#include "emptyPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- True if contact keeps objects off a patch
static bool isWall(const polyPatch& patch)
{
    return
        isA<wallPolyPatch>(patch)
     || isA<symmetryPlanePolyPatch>(patch)
     || isA<symmetryPolyPatch>(patch);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::domainSides::addPatch
(
    const polyPatch& patch,
    const scalar tolerance
)
{
    FixedList<bool, nSides> touches(false);
    for (const point& p : patch.faceCentres())
    {
        for (direction d = 0; d < 3; ++d)
        {
            touches[2*d] =
                touches[2*d] || mag(p[d] - bounds_.min()[d]) < tolerance;
            touches[2*d + 1] =
                touches[2*d + 1] || mag(p[d] - bounds_.max()[d]) < tolerance;
        }
    }
    for (label sidei = 0; sidei < nSides; ++sidei)
    {
        if (returnReduce(touches[sidei], orOp<bool>()))
        {
            const kind k = isWall(patch) ? kind::wall : kind::open;
            kinds_[sidei] = std::max(kinds_[sidei], k);
            if (k == kind::open)
            {
                patches_[sidei].append(patch.name());
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::domainSides::domainSides(const cartesianMesh& grid)
:
    bounds_(grid.bounds()),
    period_(grid.period()),
    kinds_(kind::none)
{
    // Patches of the decomposition stand behind the mesh's own
    const polyBoundaryMesh& boundary = grid.mesh().boundaryMesh();
    for (label patchi = 0; patchi < boundary.nNonProcessor(); ++patchi)
    {
        if (isWall(boundary[patchi]) || isOpen(boundary[patchi]))
        {
            addPatch(boundary[patchi], 1e-6*bounds_.mag());
        }
    }
    for (direction d = 0; d < 3; ++d)
    {
        if (period_[d] > 0)
        {
            kinds_[2*d] = kind::cyclic;
            kinds_[2*d + 1] = kind::cyclic;
        }
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::fsi::domainSides::isOpen(const polyPatch& patch)
{
    return
        !patch.coupled()
     && !isWall(patch)
     && !isA<emptyPolyPatch>(patch);
}


Foam::vector Foam::fsi::domainSides::outward(const label sidei)
{
    vector n(Zero);
    n[sidei/2] = sidei % 2 ? 1 : -1;
    return n;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::domainSides::findPatch(const word& patch) const
{
    for (label sidei = 0; sidei < nSides; ++sidei)
    {
        if (patches_[sidei].found(patch))
        {
            return sidei;
        }
    }
    return -1;
}


Foam::wordList Foam::fsi::domainSides::openPatches() const
{
    wordList names;
    for (const wordList& onSide : patches_)
    {
        names.append(onSide);
    }
    return names;
}


Foam::scalar Foam::fsi::domainSides::beyond
(
    const label sidei,
    const boundBox& box
) const
{
    const direction d = sidei/2;
    return
        sidei % 2
      ? box.min()[d] - bounds_.max()[d]
      : bounds_.min()[d] - box.max()[d];
}


Foam::List<Foam::fsi::contactWall> Foam::fsi::domainSides::walls() const
{
    DynamicList<contactWall> walls;
    for (label sidei = 0; sidei < nSides; ++sidei)
    {
        if (kinds_[sidei] == kind::wall)
        {
            walls.append
            (
                contactWall
                (
                    sidei % 2 ? bounds_.max() : bounds_.min(),
                    -outward(sidei)
                )
            );
        }
    }
    return List<contactWall>(std::move(walls));
}


Foam::fsi::periodicImages Foam::fsi::domainSides::images() const
{
    return periodicImages(bounds_, period_);
}


// ************************************************************************* //
