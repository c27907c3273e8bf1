// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "mathematicalConstants.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedFluid::setCutFaces
(
    const volVectorField& U,
    const vectorField& wallVelocity,
    const volVectorField* increment,
    surfaceScalarField& velocity
) const
{
    const fvMesh& mesh = U.mesh();
    const label nInternal = mesh.nInternalFaces();

    // Not set on empty patches, which are large
    scalarField onBoundary(mesh.nFaces() - nInternal);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            SubList<scalar>(onBoundary, patch.size(), patch.start() - nInternal)
                = Zero;
        }
    }
    const auto set = [&](const label facei, const scalar value)
    {
        (
            facei < nInternal
          ? velocity[facei]
          : onBoundary[facei - nInternal]
        ) = geometry_.grid().faceAlong(facei) ? value : -value;
    };

    // Between a fluid cell's centre and the wall
    for (const wallLink& link : geometry_.wallLinks())
    {
        const scalar wall = link.place.interpolate(wallVelocity, link.dir);
        const scalar part = min(0.5/link.wallDistance, 1.0);
        scalar value = (1 - part)*U[link.cell][link.dir] + part*wall;
        if (increment)
        {
            value += (*increment)[link.cell][link.dir];
        }
        set(link.face, value);
    }

    // Between two cells with their centres inside objects. Across a coupled
    // patch each side gives half
    for (const label walli : geometry_.innerFaces())
    {
        const wallFace& w = geometry_.wallFaces()[walli];
        const label own = mesh.faceOwner()[w.face];
        const bool internal = w.face < nInternal;
        const label nei = internal ? mesh.faceNeighbour()[w.face] : own;
        scalar value = w.place.interpolate(wallVelocity, w.dir);
        if (increment)
        {
            value += 0.5*((*increment)[own][w.dir] + (*increment)[nei][w.dir]);
        }
        set(w.face, internal ? value : 0.5*value);
    }
    setCutPatchFaces(onBoundary, velocity);
}


void Foam::fsi::immersedFluid::setCutPatchFaces
(
    const scalarField& onBoundary,
    surfaceScalarField& velocity
) const
{
    // The side of a coupled patch that holds the fluid cell tells the other,
    // whose normal is the opposite. On a patch of the domain the velocity is
    // the patch's own
    scalarField across(onBoundary);
    syncTools::swapBoundaryFaceList(velocity.mesh(), across);
    const label nInternal = velocity.mesh().nInternalFaces();
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    forAll(velocity.boundaryField(), patchi)
    {
        fvsPatchScalarField& pv = velocity.boundaryFieldRef()[patchi];
        if (pv.coupled())
        {
            forAll(pv, i)
            {
                if (fluidFace.boundaryField()[patchi][i] < 0.5)
                {
                    const label facei = pv.patch().start() + i - nInternal;
                    pv[i] = onBoundary[facei] - across[facei];
                }
            }
        }
    }
}


Foam::tmp<Foam::surfaceScalarField>
Foam::fsi::immersedFluid::interpolatedVelocity(const volVectorField& U) const
{
    const fvMesh& mesh = U.mesh();
    const cartesianMesh& grid = geometry_.grid();
    auto tvelocity = tmp<surfaceScalarField>::New
    (
        IOobject("faceVelocity", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimVelocity, Zero)
    );
    surfaceScalarField& velocity = tvelocity.ref();
    velocity.setOriented();

    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        const direction d = grid.faceDirection(facei);
        const scalar mean = 0.5*(U[own[facei]][d] + U[nei[facei]][d]);
        velocity[facei] = grid.faceAlong(facei) ? mean : -mean;
    }
    forAll(velocity.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        const vectorField onPatch
        (
            pU.coupled()
          ? 0.5*(pU.patchInternalField() + pU.patchNeighbourField())
          : tmp<vectorField>(pU)
        );
        velocity.boundaryFieldRef()[patchi] = onPatch & pU.patch().nf();
    }

    return tvelocity;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::immersedFluid::faceVelocity
(
    const volVectorField& U,
    const vectorField& wallVelocity,
    const volVectorField* increment
) const
{
    tmp<surfaceScalarField> tvelocity;
    if (increment)
    {
        // Patches that fix the velocity keep it
        volVectorField sum("HbyA", U);
        sum.primitiveFieldRef() += increment->primitiveField();
        sum.correctBoundaryConditions();
        tvelocity = interpolatedVelocity(sum);
    }
    else
    {
        tvelocity = interpolatedVelocity(U);
    }
    setCutFaces(U, wallVelocity, increment, tvelocity.ref());
    return tvelocity;
}


Foam::scalarField Foam::fsi::immersedFluid::fadingInStep
(
    const volVectorField& U,
    const scalar viscosity
) const
{
    const scalar h = geometry_.grid().spacing();
    const scalar deltaT = U.time().deltaTValue();
    const scalar viscous = viscosity*sqr(constant::mathematical::pi/h);

    scalarField fading(U.size());
    forAll(fading, celli)
    {
        fading[celli] = deltaT*(viscous + mag(U[celli])/h);
    }
    return fading;
}


Foam::scalar Foam::fsi::immersedFluid::kept
(
    const scalar velocity,
    const scalar interpolated,
    const scalar fading
) const
{
    const scalar difference = velocity - interpolated;
    switch (history_)
    {
        case history::fading: return difference/(1 + fading);
        case history::full:   return difference;
        case history::none:   return 0;
        case history::limited: break;
    }
    return
        difference
       *(1 - min(mag(difference)/(mag(velocity) + VSMALL), 1.0));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::fsi::immersedFluid::faceFlux
(
    const volVectorField& U,
    const volVectorField& gradient,
    const scalar rAU,
    const vectorField& wallVelocity
) const
{
    volVectorField increment("increment", gradient);
    increment.primitiveFieldRef() *= rAU;

    return tmp<surfaceScalarField>::New
    (
        "phiHbyA",
        (faceVelocity(U, wallVelocity, &increment) + faceHistory_)
       *U.mesh().magSf()*geometry_.openArea()
    );
}


void Foam::fsi::immersedFluid::storeFaceVelocity
(
    const surfaceScalarField& phi,
    const volVectorField& U,
    const vectorField& wallVelocity,
    const scalar viscosity
)
{
    const surfaceScalarField interpolated
    (
        faceVelocity(U, wallVelocity, nullptr)
    );
    const surfaceScalarField& open = geometry_.openArea();
    const surfaceScalarField& area = U.mesh().magSf();
    const scalarField fading(fadingInStep(U, viscosity));
    scalarField across;
    swapCoupledCells(U.mesh(), fading, across);

    const labelUList& own = U.mesh().owner();
    const labelUList& nei = U.mesh().neighbour();
    forAll(open, facei)
    {
        faceHistory_[facei] =
            open[facei] > 0
          ? kept
            (
                phi[facei]/(open[facei]*area[facei]),
                interpolated[facei],
                0.5*(fading[own[facei]] + fading[nei[facei]])
            )
          : 0;
    }
    forAll(open.boundaryField(), patchi)
    {
        const fvsPatchScalarField& po = open.boundaryField()[patchi];
        fvsPatchScalarField& ph = faceHistory_.boundaryFieldRef()[patchi];
        const labelUList& cells = po.patch().faceCells();
        const label first = po.patch().start() - U.mesh().nInternalFaces();
        forAll(po, i)
        {
            ph[i] =
                po.coupled() && po[i] > 0
              ? kept
                (
                    phi.boundaryField()[patchi][i]
                   /(po[i]*area.boundaryField()[patchi][i]),
                    interpolated.boundaryField()[patchi][i],
                    0.5*(fading[cells[i]] + across[first + i])
                )
              : 0;
        }
    }
}


// ************************************************************************* //
