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


Foam::scalar Foam::fsi::immersedFluid::history
(
    const scalar velocity,
    const scalar interpolated
) const
{
    const scalar difference = velocity - interpolated;
    return
        difference
       *(
            ddtPhiCoeff_ < 0
          ? 1 - min(mag(difference)/(mag(velocity) + VSMALL), 1.0)
          : ddtPhiCoeff_
        );
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
    boolList cutCell(U.size(), false);
    forAll(cutCell, celli)
    {
        cutCell[celli] = !geometry_.fluidCell()[celli];
    }
    for (const wallLink& link : geometry_.wallLinks())
    {
        cutCell[link.cell] = true;
    }
    boolList cutAcross;
    syncTools::swapBoundaryCellList(U.mesh(), cutCell, cutAcross);

    // Next to walls the difference fades as the slowest shear flow between
    // walls a cell apart does
    const scalar fading =
        sqr(constant::mathematical::pi/geometry_.grid().spacing())*viscosity;
    const scalar kept = 1/(1 + fading*U.time().deltaTValue());

    const labelUList& own = U.mesh().owner();
    const labelUList& nei = U.mesh().neighbour();
    forAll(open, facei)
    {
        const bool cut = cutCell[own[facei]] || cutCell[nei[facei]];
        faceHistory_[facei] =
            open[facei] > 0
          ? (cut ? kept : 1)*history
            (
                phi[facei]/(open[facei]*area[facei]),
                interpolated[facei]
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
            const bool cut = cutCell[cells[i]] || cutAcross[first + i];
            ph[i] =
                po.coupled() && po[i] > 0
              ? (cut ? kept : 1)*history
                (
                    phi.boundaryField()[patchi][i]
                   /(po[i]*area.boundaryField()[patchi][i]),
                    interpolated.boundaryField()[patchi][i]
                )
              : 0;
        }
    }
}


// ************************************************************************* //
