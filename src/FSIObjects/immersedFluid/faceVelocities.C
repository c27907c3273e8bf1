// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceVelocities.H"
#include "openfoamMesh.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::faceVelocities::setCutFaces
(
    const sources& v,
    const wanted what,
    surfaceScalarField& result
) const
{
    const fvMesh& mesh = v.U.mesh();
    const label nInternal = mesh.nInternalFaces();
    const surfaceScalarField& open = geometry_.openArea();
    const scalar scale =
        what == wanted::wholeFlux ? geometry_.grid().faceArea() : 1;

    scalarField onBoundary;
    boolList isSet;
    setZeroOnCoupled(mesh, onBoundary);
    setZeroOnCoupled(mesh, isSet);
    const auto set = [&](const label facei, const scalar along)
    {
        const scalar value =
            geometry_.grid().faceAlong(facei) ? scale*along : -scale*along;
        if (facei >= nInternal)
        {
            onBoundary[facei - nInternal] = value;
            isSet[facei - nInternal] = true;
        }
        else if (what == wanted::velocity || open[facei] < 1)
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
        fetchAhead(open[face]);
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
    setCutPatchFaces(onBoundary, isSet, what, result);
}


void Foam::fsi::faceVelocities::setCutPatchFaces
(
    const scalarField& onBoundary,
    const boolList& isSet,
    const wanted what,
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
        const fvsPatchScalarField& open =
            geometry_.openArea().boundaryField()[patchi];
        for (label i = 0; i < pr.size() && pr.coupled(); ++i)
        {
            const label facei = pr.patch().start() + i - nInternal;
            if
            (
                fluidFace[i] < 0.5
             && (isSet[facei] || setAcross[facei])
             && (what == wanted::velocity || open[i] < 1)
            )
            {
                pr[i] = onBoundary[facei] - across[facei];
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

    auto tvelocity = newTmp<surfaceScalarField>
    (
        IOobject("faceVelocity", nameOf(mesh.time()), mesh),
        mesh,
        dimVelocity
    );
    surfaceScalarField& velocity = tvelocity.ref();
    setOriented(velocity);
    const vectorField& cells = sum().primitiveField();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(velocity, facei)
    {
        velocity[facei] = mean(cells, own, nei, facei);
    }
    forAll(velocity.boundaryField(), patchi)
    {
        velocity.boundaryFieldRef()[patchi] = patchMean(sum(), patchi);
    }
    setCutFaces(v, wanted::velocity, velocity);
    return tvelocity;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::faceVelocities::velocity
(
    const sources& v
) const
{
    tmp<surfaceScalarField> tvelocity(middleVelocity(v));
    addOpenParts(v, tvelocity.ref());
    return tvelocity;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::faceVelocities::wholeFlux
(
    const surfaceScalarField& phi,
    const volVectorField& U,
    const vectorField& wallVelocity
) const
{
    const surfaceScalarField& open = geometry_.openArea();
    const scalar area = geometry_.grid().faceArea();
    auto tflux = newTmp<surfaceScalarField>("convectiveFlux", phi);
    surfaceScalarField& flux = tflux.ref();
    const labelUList& own = U.mesh().owner();
    const labelUList& nei = U.mesh().neighbour();
    forAll(flux, facei)
    {
        if (open[facei] < 1)
        {
            flux[facei] = area*mean(U, own, nei, facei);
        }
    }
    forAll(flux.boundaryField(), patchi)
    {
        fvsPatchScalarField& pf = flux.boundaryFieldRef()[patchi];
        if (pf.coupled())
        {
            const scalarField whole(area*patchMean(U, patchi));
            forAll(pf, i)
            {
                if (open.boundaryField()[patchi][i] < 1)
                {
                    pf[i] = whole[i];
                }
            }
        }
    }
    setCutFaces({U, wallVelocity, nullptr, 0}, wanted::wholeFlux, flux);
    return tflux;
}


// ************************************************************************* //
