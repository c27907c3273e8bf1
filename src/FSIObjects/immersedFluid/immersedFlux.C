// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "mathematicalConstants.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::fsi::immersedFluid::cutFaceVelocity
(
    const volVectorField& U,
    const vectorField& wallVelocity,
    const volVectorField* increment
) const
{
    const fvMesh& mesh = U.mesh();
    auto tvelocity = tmp<scalarField>::New(mesh.nFaces(), Zero);
    scalarField& velocity = tvelocity.ref();

    // Between a fluid cell's centre and the wall
    for (const wallLink& link : geometry_.wallLinks())
    {
        const scalar wall = link.place.interpolate(wallVelocity, link.dir);
        const scalar part = min(0.5/link.wallDistance, 1.0);
        velocity[link.face] = (1 - part)*U[link.cell][link.dir] + part*wall;
        if (increment)
        {
            velocity[link.face] += (*increment)[link.cell][link.dir];
        }
    }

    // Between two cells with their centres inside objects. Across a coupled
    // patch each side gives half
    for (const label walli : geometry_.innerFaces())
    {
        const wallFace& w = geometry_.wallFaces()[walli];
        const label own = mesh.faceOwner()[w.face];
        const bool internal = w.face < mesh.nInternalFaces();
        const label nei = internal ? mesh.faceNeighbour()[w.face] : own;
        const scalar half = internal ? 1 : 0.5;
        velocity[w.face] = half*w.place.interpolate(wallVelocity, w.dir);
        if (increment)
        {
            velocity[w.face] +=
                0.5*half
               *((*increment)[own][w.dir] + (*increment)[nei][w.dir]);
        }
    }

    // The side of a coupled patch that holds the fluid cell tells the other
    SubList<scalar> boundary
    (
        velocity,
        mesh.nFaces() - mesh.nInternalFaces(),
        mesh.nInternalFaces()
    );
    scalarField onBoundary(boundary);
    syncTools::syncBoundaryFaceList(mesh, onBoundary, plusEqOp<scalar>());
    boundary = onBoundary;

    return tvelocity;
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
        velocity[facei] = mesh.Sf()[facei][d] > 0 ? mean : -mean;
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
    const fvMesh& mesh = U.mesh();
    const scalarField cut(cutFaceVelocity(U, wallVelocity, increment));
    const surfaceScalarField& fluidFace = geometry_.fluidFace();

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
    surfaceScalarField& velocity = tvelocity.ref();

    const auto set = [&](const label facei, scalar& value)
    {
        const direction dir = geometry_.grid().faceDirection(facei);
        value = mesh.faceAreas()[facei][dir] > 0 ? cut[facei] : -cut[facei];
    };
    forAll(mesh.owner(), facei)
    {
        if (fluidFace[facei] < 0.5)
        {
            set(facei, velocity[facei]);
        }
    }
    forAll(velocity.boundaryField(), patchi)
    {
        // On a patch of the domain the velocity is the patch's own
        fvsPatchScalarField& pv = velocity.boundaryFieldRef()[patchi];
        if (pv.coupled())
        {
            forAll(pv, i)
            {
                if (fluidFace.boundaryField()[patchi][i] < 0.5)
                {
                    set(pv.patch().start() + i, pv[i]);
                }
            }
        }
    }

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
    syncTools::swapBoundaryCellList(U.mesh(), fading, across);

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
