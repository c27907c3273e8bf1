// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceVelocities.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::faceVelocities::setCutFaces
(
    const sources& v,
    surfaceScalarField& result
) const
{
    const fvMesh& mesh = v.U.mesh();
    const label nInternal = mesh.nInternalFaces();

    scalarField onBoundary;
    boolList isSet;
    setZeroOnCoupled(mesh, onBoundary);
    setZeroOnCoupled(mesh, isSet);
    const auto set = [&](const label facei, const scalar along)
    {
        const scalar value =
            geometry_.grid().faceAlong(facei) ? along : -along;
        if (facei >= nInternal)
        {
            onBoundary[facei - nInternal] = value;
            isSet[facei - nInternal] = true;
        }
        else
        {
            result[facei] = value;
        }
    };

    const UList<wallLink>& links = geometry_.wallLinks();
    forAll(links, i)
    {
        const wallLink& later = fetchedAhead(links, i);
        const label face = min(later.face, nInternal - 1);
        v.fetch(later.cell);
        fetchAhead(result[face]);
        fetchAhead(v.wall[later.place.nodes[0]]);
        set(links[i].face, v.velocity(links[i]));
    }
    const UList<wallFace>& walls = geometry_.wallFaces();
    const UList<label>& inner = geometry_.innerFaces();
    forAll(inner, i)
    {
        fetchAhead(walls[fetchedAhead(inner, i, 24)]);
        const wallFace& later = walls[fetchedAhead(inner, i)];
        fetchAhead(result[min(later.face, nInternal - 1)]);
        fetchAhead(v.wall[later.place.nodes[0]]);
        set(walls[inner[i]].face, v.velocity(walls[inner[i]]));
    }
    setCutPatchFaces(onBoundary, isSet, result);
}


void Foam::fsi::faceVelocities::setCutPatchFaces
(
    const scalarField& onBoundary,
    const boolList& isSet,
    surfaceScalarField& result
) const
{
    // The side of a coupled patch that holds the fluid cell tells the other,
    // whose normal is the opposite. Where neither sets it, in a film between
    // two solid cells, the face keeps its value. On a patch of the domain the
    // velocity is the patch's own
    scalarList across;
    boolList setAcross;
    swapCoupledFaces(result.mesh(), onBoundary, across);
    swapCoupledFaces(result.mesh(), isSet, setAcross);
    const label nInternal = result.mesh().nInternalFaces();
    forAll(result.boundaryField(), patchi)
    {
        fvsPatchScalarField& pr = result.boundaryFieldRef()[patchi];
        const fvsPatchScalarField& fluidFace =
            geometry_.fluidFace().boundaryField()[patchi];
        for (label i = 0; i < pr.size() && pr.coupled(); ++i)
        {
            const label facei = pr.patch().start() + i - nInternal;
            if
            (
                fluidFace[i] < 0.5
             && (isSet[facei] || setAcross[facei])
            )
            {
                pr[i] = onBoundary[facei] - across[facei];
            }
        }
    }
}


void Foam::fsi::faceVelocities::setFilms
(
    const vectorField& wall,
    surfaceScalarField& result
) const
{
    const fvMesh& mesh = result.mesh();
    const label nInternal = mesh.nInternalFaces();
    scalarField onBoundary;
    setZeroOnCoupled(mesh, onBoundary);
    for (const filmFace& film : geometry_.films().faces())
    {
        const scalar along = film.velocity(wall);
        const scalar value =
            geometry_.grid().faceAlong(film.face) ? along : -along;
        if (film.face < nInternal)
        {
            result[film.face] = value;
        }
        else
        {
            onBoundary[film.face - nInternal] = 0.5*value;
        }
    }
    // All ranks swap, be they without coupled faces
    if (!severalRanks() && !geometry_.grid().coupled())
    {
        return;
    }
    // Both sides of a coupled patch to the last bit
    scalarList across;
    swapCoupledFaces(mesh, onBoundary, across);
    for (fvsPatchScalarField& pr : result.boundaryFieldRef())
    {
        for (label i = 0; i < pr.size() && pr.coupled(); ++i)
        {
            const label facei = pr.patch().start() + i;
            if (geometry_.films().has(facei))
            {
                pr[i] =
                    onBoundary[facei - nInternal] - across[facei - nInternal];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::faceVelocities::patchMean
(
    const volVectorField& U,
    const label patchi
)
{
    const fvPatchVectorField& pU = U.boundaryField()[patchi];
    const tmp<vectorField> onPatch
    (
        pU.coupled()
      ? 0.5*(pU.patchInternalField() + pU.patchNeighbourField())
      : tmp<vectorField>(pU)
    );
    return onPatch & pU.patch().nf();
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::faceVelocities::patchVelocity
(
    const volVectorField& U
)
{
    const fvMesh& mesh = U.mesh();
    auto tvelocity = newTmp<surfaceScalarField>
    (
        IOobject("faceVelocity", nameOf(mesh.time()), mesh),
        mesh,
        dimVelocity
    );
    surfaceScalarField& velocity = tvelocity.ref();
    setOriented(velocity);
    forAll(velocity.boundaryField(), patchi)
    {
        velocity.boundaryFieldRef()[patchi] = patchMean(U, patchi);
    }
    return tvelocity;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::faceVelocities::middleVelocity
(
    const sources& v
) const
{
    const fvMesh& mesh = v.U.mesh();
    tmp<volVectorField> sum(v.U);
    if (v.gradient)
    {
        // Patches that fix the velocity keep it
        sum = newTmp<volVectorField>("HbyA", v.U);
        vectorField& u = sum.ref().primitiveFieldRef();
        forAll(u, celli)
        {
            u[celli] += v.rAU*(*v.gradient)[celli];
        }
        sum.ref().correctBoundaryConditions();
    }

    tmp<surfaceScalarField> tvelocity(patchVelocity(sum()));
    surfaceScalarField& velocity = tvelocity.ref();
    const vectorField& cells = sum().primitiveField();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(velocity, facei)
    {
        velocity[facei] = mean(cells, own, nei, facei);
    }
    setCutFaces(v, velocity);
    return tvelocity;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::faceVelocities::velocity
(
    const sources& v
) const
{
    tmp<surfaceScalarField> tvelocity(middleVelocity(v));
    addOpenParts(v, tvelocity.ref());
    setFilms(v.wall, tvelocity.ref());
    return tvelocity;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::faceVelocities::nearVelocity
(
    const volVectorField& U,
    const vectorField& wallVelocity,
    const UList<label>& some
) const
{
    // Pages of other faces are never touched
    const fvMesh& mesh = U.mesh();
    tmp<surfaceScalarField> tvelocity(patchVelocity(U));
    surfaceScalarField& velocity = tvelocity.ref();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    for (const label facei : some)
    {
        if (facei < mesh.nInternalFaces())
        {
            velocity[facei] = mean(U, own, nei, facei);
        }
    }
    const sources v{U, wallVelocity, nullptr, 0};
    setCutFaces(v, velocity);
    addOpenParts(v, velocity);
    setFilms(wallVelocity, velocity);
    return tvelocity;
}


// ************************************************************************* //
