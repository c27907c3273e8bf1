// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "levelSetUpdate.H"
#include "syncTools.H"
#include "surfaceInterpolate.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::fsi::immersedFluid::wallFaceVelocity
(
    const volVectorField& U,
    const volVectorField& gradient,
    const scalar rAU,
    const surfaceSet& surfaces,
    const vectorField& wallVelocity,
    const levelSetUpdate& levelSet
) const
{
    const fvMesh& mesh = U.mesh();
    const boolList& fluid = geometry_.fluidCell();
    auto tvelocity = tmp<scalarField>::New(mesh.nFaces(), Zero);
    scalarField& velocity = tvelocity.ref();

    // Between a fluid cell's centre and the wall
    boolList linked(mesh.nFaces(), false);
    for (const wallLink& link : geometry_.wallLinks())
    {
        linked[link.face] = true;
        const scalar wall = link.place.interpolate(wallVelocity, link.dir);
        const scalar part = min(0.5/link.wallDistance, 1.0);
        velocity[link.face] =
            (1 - part)*U[link.cell][link.dir] + part*wall
          + rAU*gradient[link.cell][link.dir];
    }

    // Between two cells with their centres inside objects. Across a coupled
    // patch each side gives half; there the link is known to its cell's rank
    syncTools::syncFaceList(mesh, linked, orEqOp<bool>());
    for (const wallFace& w : geometry_.wallFaces())
    {
        const label own = mesh.faceOwner()[w.face];
        const bool internal = w.face < mesh.nInternalFaces();
        const label nei = internal ? mesh.faceNeighbour()[w.face] : own;
        if (geometry_.openness()[w.face] <= 0 || fluid[own] || linked[w.face])
        {
            continue;
        }
        const scalar half = internal ? 1 : 0.5;
        velocity[w.face] =
            half
           *(
                w.place.interpolate(wallVelocity, w.dir)
              + 0.5*rAU*(gradient[own][w.dir] + gradient[nei][w.dir])
            );
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::fsi::immersedFluid::faceFlux
(
    const volVectorField& U,
    const volVectorField& gradient,
    const scalar rAU,
    const surfaceSet& surfaces,
    const vectorField& wallVelocity,
    const levelSetUpdate& levelSet
) const
{
    const fvMesh& mesh = U.mesh();

    tmp<surfaceScalarField> tphi(interpolatedFlux(U, gradient, rAU));
    surfaceScalarField& phi = tphi.ref();

    const scalarField wall
    (
        wallFaceVelocity
        (
            U,
            gradient,
            rAU,
            surfaces,
            wallVelocity,
            levelSet
        )
    );

    const auto cut = [&]
    (
        const label facei,
        const scalar bothFluid,
        scalar& flux
    )
    {
        const scalar open = geometry_.openness()[facei];
        if (bothFluid < 0.5)
        {
            const direction dir = geometry_.grid().faceDirection(facei);
            flux = wall[facei]*mesh.faceAreas()[facei][dir];
        }
        flux *= open;
    };

    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    forAll(mesh.owner(), facei)
    {
        cut(facei, fluidFace[facei], phi[facei]);
    }
    forAll(phi.boundaryField(), patchi)
    {
        fvsPatchScalarField& pphi = phi.boundaryFieldRef()[patchi];
        const label start = pphi.patch().start();
        forAll(pphi, i)
        {
            // On a patch of the domain the velocity is the patch's own
            const scalar bothFluid =
                pphi.coupled() ? fluidFace.boundaryField()[patchi][i] : 1;
            cut(start + i, bothFluid, pphi[i]);
        }
    }

    return tphi;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::fsi::immersedFluid::interpolatedFlux
(
    const volVectorField& U,
    const volVectorField& gradient,
    const scalar rAU
) const
{
    // Patches that fix the velocity keep it
    volVectorField HbyA("HbyA", U);
    HbyA.primitiveFieldRef() += rAU*gradient.primitiveField();
    HbyA.correctBoundaryConditions();

    auto tphi = tmp<surfaceScalarField>::New
    (
        "phiHbyA",
        fvc::interpolate(HbyA) & U.mesh().Sf()
    );
    addHistory(U.oldTime(), tphi.ref());
    return tphi;
}


void Foam::fsi::immersedFluid::addHistory
(
    const volVectorField& U0,
    surfaceScalarField& phi
) const
{
    const fvMesh& mesh = phi.mesh();
    const surfaceScalarField interpolated(fvc::interpolate(U0) & mesh.Sf());
    const surfaceScalarField& fluidFace = geometry_.fluidFace();

    const auto add = [&]
    (
        const scalar bothFluid,
        const scalar faceVelocity,
        const vector& area,
        const scalar fluxU0,
        scalar& flux
    )
    {
        if (bothFluid < 0.5 || faceVelocity > 0.5*GREAT)
        {
            return;
        }
        const scalar flux0 = faceVelocity*(area.x() + area.y() + area.z());
        const scalar difference = flux0 - fluxU0;
        const scalar coeff =
            ddtPhiCoeff_ < 0
          ? 1 - min(mag(difference)/(mag(flux0) + VSMALL), 1.0)
          : ddtPhiCoeff_;
        flux += coeff*difference;
    };

    forAll(mesh.owner(), facei)
    {
        add
        (
            fluidFace[facei],
            faceVelocity_[facei],
            mesh.Sf()[facei],
            interpolated[facei],
            phi[facei]
        );
    }
    forAll(phi.boundaryField(), patchi)
    {
        fvsPatchScalarField& pphi = phi.boundaryFieldRef()[patchi];
        if (pphi.coupled())
        {
            forAll(pphi, i)
            {
                add
                (
                    fluidFace.boundaryField()[patchi][i],
                    faceVelocity_.boundaryField()[patchi][i],
                    mesh.Sf().boundaryField()[patchi][i],
                    interpolated.boundaryField()[patchi][i],
                    pphi[i]
                );
            }
        }
    }
}


void Foam::fsi::immersedFluid::storeFaceVelocity(const surfaceScalarField& phi)
{
    const fvMesh& mesh = phi.mesh();
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    const surfaceScalarField& open = geometry_.openArea();

    // Faces are normal to an axis: the sum is the component along it
    const auto velocity = []
    (
        const scalar bothFluid,
        const scalar open,
        const vector& area,
        const scalar flux
    )
    {
        return
            bothFluid > 0.5 && open > 0
          ? flux/(open*(area.x() + area.y() + area.z()))
          : GREAT;
    };

    forAll(mesh.owner(), facei)
    {
        faceVelocity_[facei] = velocity
        (
            fluidFace[facei],
            open[facei],
            mesh.Sf()[facei],
            phi[facei]
        );
    }
    forAll(phi.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pphi = phi.boundaryField()[patchi];
        if (pphi.coupled())
        {
            forAll(pphi, i)
            {
                faceVelocity_.boundaryFieldRef()[patchi][i] = velocity
                (
                    fluidFace.boundaryField()[patchi][i],
                    open.boundaryField()[patchi][i],
                    mesh.Sf().boundaryField()[patchi][i],
                    pphi[i]
                );
            }
        }
    }
}


// ************************************************************************* //
