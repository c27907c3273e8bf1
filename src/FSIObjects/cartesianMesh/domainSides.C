// SPDX-License-Identifier: GPL-3.0-or-later

#include "domainSides.H"
#include "emptyPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::domainSides::kind
Foam::fsi::domainSides::kindOf(const polyPatch& patch)
{
    if (isA<wallPolyPatch>(patch) || isA<symmetryPlanePolyPatch>(patch))
    {
        return WALL;
    }
    if (isA<emptyPolyPatch>(patch))
    {
        return EMPTY;
    }
    // Faces between ranks lie on a side only where the domain repeats
    return patch.coupled() ? CYCLIC : OPEN;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::domainSides::domainSides(const fvMesh& mesh)
:
    bounds_(mesh.bounds()),
    kinds_(label(EMPTY))
{
    const scalar tolerance = 1e-6*bounds_.mag();

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const label kind = kindOf(patch);
        for (const point& p : patch.faceCentres())
        {
            for (direction d = 0; d < 3; ++d)
            {
                if (mag(p[d] - bounds_.min()[d]) < tolerance)
                {
                    kinds_[2*d] = max(kinds_[2*d], kind);
                }
                if (mag(p[d] - bounds_.max()[d]) < tolerance)
                {
                    kinds_[2*d + 1] = max(kinds_[2*d + 1], kind);
                }
            }
        }
    }
    for (label& kind : kinds_)
    {
        reduce(kind, maxOp<label>());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::domainSides::period() const
{
    vector length(Zero);
    for (direction d = 0; d < 3; ++d)
    {
        if (kinds_[2*d] == CYCLIC && kinds_[2*d + 1] == CYCLIC)
        {
            length[d] = bounds_.span()[d];
        }
    }
    return length;
}


// ************************************************************************* //
