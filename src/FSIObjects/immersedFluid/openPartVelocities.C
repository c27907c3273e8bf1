// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceVelocities.H"
#include "sumOverRanks.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::faceVelocities::beyondMiddle
(
    const sources& v,
    const vectorList& across,
    const openFace& o
) const
{
    scalar along = 0;
    if (o.middleClosed)
    {
        const surfacePlace& place = geometry_.wallFaces()[o.wall].place;
        along = (1 - o.beyond)*place.interpolate(v.wall, o.dir);
        along *= o.sides[1] >= 0 ? 1 : 0.5;
    }
    for (label i = 0; i < 2 && o.sides[i] >= 0; ++i)
    {
        const label next = o.cells[i];
        const vector& U = next < 0 ? across[-2 - next] : v.U[next];
        along +=
            0.5*o.beyond*U[o.dir]
          + o.part()*o.increments[i]*v.increment(o.sides[i], o.dir);
    }
    return along;
}


void Foam::fsi::faceVelocities::addOpenParts
(
    const sources& v,
    surfaceScalarField& result
) const
{
    const fvMesh& mesh = v.U.mesh();
    const label nInternal = mesh.nInternalFaces();
    // All ranks swap, be they without coupled faces
    const bool coupled = severalRanks() || geometry_.grid().coupled();
    vectorList across;
    scalarField onBoundary, share;
    if (coupled)
    {
        swapCoupledCells(mesh, v.U.primitiveField(), across);
        setZeroOnCoupled(mesh, onBoundary);
        setZeroOnCoupled(mesh, share);
    }
    const UList<openFace>& faces = geometry_.openFaces();
    forAll(faces, i)
    {
        const openFace& later = fetchedAhead(faces, i);
        fetchAhead(geometry_.wallFaces()[later.wall].place);
        fetchAhead(result[min(later.face, nInternal - 1)]);
        for (label side = 0; side < 2; ++side)
        {
            v.fetch(max(later.cells[side], 0));
            v.fetch(max(later.sides[side], 0));
        }
        const openFace& o = faces[i];
        const label facei = o.face;
        const scalar along = beyondMiddle(v, across, o);
        if (facei < nInternal)
        {
            result[facei] *= 1 - o.part();
            result[facei] +=
                geometry_.grid().faceAlong(facei) ? along : -along;
        }
        else
        {
            onBoundary[facei - nInternal] = along;
            share[facei - nInternal] = o.part();
        }
    }
    if (coupled)
    {
        addOpenPatchParts(onBoundary, share, result);
    }
}


void Foam::fsi::faceVelocities::addOpenPatchParts
(
    const scalarField& along,
    const scalarField& share,
    surfaceScalarField& result
) const
{
    scalarList across;
    swapCoupledFaces(result.mesh(), along, across);
    const label nInternal = result.mesh().nInternalFaces();
    for (fvsPatchScalarField& pr : result.boundaryFieldRef())
    {
        for (label i = 0; i < pr.size() && pr.coupled(); ++i)
        {
            const label facei = pr.patch().start() + i;
            const label place = facei - nInternal;
            const scalar both = along[place] + across[place];
            pr[i] *= 1 - share[place];
            pr[i] += geometry_.grid().faceAlong(facei) ? both : -both;
        }
    }
}


// ************************************************************************* //
