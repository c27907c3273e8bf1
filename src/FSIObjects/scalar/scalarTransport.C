// SPDX-License-Identifier: GPL-3.0-or-later

#include "scalarTransport.H"
#include "IStringStream.H"
#include "fvcSurfaceIntegrate.H"
#include "openLaplacian.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceInterpolationScheme<Foam::scalar>>
Foam::fsi::scalarTransport::interpolation(const surfaceScalarField& flux) const
{
    const fvMesh& mesh = C_.mesh();
    const word key("div(phi," + C_.name() + ')');
    const word schemes("divSchemes");
    if (!schemesOf(mesh).subOrEmptyDict(schemes).found(key))
    {
        IStringStream scheme("limitedLinear 1");
        return surfaceInterpolationScheme<scalar>::New(mesh, flux, scheme);
    }
    ITstream& scheme = divSchemeOf(mesh, key);
    const word kind(scheme);
    if (kind != "Gauss")
    {
        FatalIOErrorInFunction(schemesOf(mesh))
            << "Entry '" << key << "' of divSchemes is " << kind
            << " but must be Gauss with an interpolation, as Gauss upwind"
            << exit(FatalIOError);
    }
    return surfaceInterpolationScheme<scalar>::New(mesh, flux, scheme);
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::scalarTransport::weightsOf
(
    const surfaceScalarField& flux,
    const volScalarField& share,
    const surfaceInterpolationScheme<scalar>& scheme
) const
{
    auto tweights = newTmp<surfaceScalarField>(scheme.weights(C_));
    surfaceScalarField& weights = tweights.ref();
    // The limiter of OpenFOAM takes the sign of the difference of two values.
    // Where they are equal the two sides of a coupled face would take another
    // one, and the face would not keep the amount
    const auto limit =
        [&]
        (
            const FixedList<scalar, 2>& shares,
            const FixedList<scalar, 2>& C,
            const scalar f,
            scalar& weight
        )
    {
        if
        (
            min(shares[0], shares[1]) < leastShare
         || mag(C[0] - C[1]) <= 1e-12*max(mag(C[0]), mag(C[1]))
        )
        {
            weight = f >= 0 ? 1 : 0;
        }
    };
    const labelUList& own = C_.mesh().owner();
    const labelUList& nei = C_.mesh().neighbour();
    forAll(own, facei)
    {
        limit
        (
            {share[own[facei]], share[nei[facei]]},
            {C_[own[facei]], C_[nei[facei]]},
            flux[facei],
            weights[facei]
        );
    }
    forAll(flux.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pf = flux.boundaryField()[patchi];
        if (pf.coupled())
        {
            const fvPatchScalarField& pv = share.boundaryField()[patchi];
            const fvPatchScalarField& pC = C_.boundaryField()[patchi];
            const scalarField inside(pv.patchInternalField());
            const scalarField across(pv.patchNeighbourField());
            const scalarField C(pC.patchInternalField());
            const scalarField acrossC(pC.patchNeighbourField());
            scalarField& ofPatch = weights.boundaryFieldRef()[patchi];
            forAll(pf, i)
            {
                limit
                (
                    {inside[i], across[i]},
                    {C[i], acrossC[i]},
                    pf[i],
                    ofPatch[i]
                );
            }
        }
    }
    return tweights;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::scalarTransport::perFace
(
    const char* name,
    const std::function<scalar(label, bool, bool)>& value
) const
{
    const fvMesh& mesh = C_.mesh();
    auto tfield = newTmp<surfaceScalarField>
    (
        IOobject(C_.name() + name, nameOf(mesh.time()), mesh),
        mesh,
        dimensionedScalar(dimless, Zero)
    );
    surfaceScalarField& field = tfield.ref();

    // Of each cell: is it fixed, is it beside a surface of a fixed value?
    const boolList& fixed = surfaces_.fixed();
    const boolList& beside = surfaces_.beside();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        field[facei] = value
        (
            facei,
            fixed[own[facei]] || fixed[nei[facei]],
            beside[own[facei]] || beside[nei[facei]]
        );
    }
    labelList kinds(fixed.size());
    forAll(kinds, celli)
    {
        kinds[celli] = fixed[celli] ? 2 : beside[celli] ? 1 : 0;
    }
    labelList across;
    swapCoupledCells(mesh, kinds, across);
    for (fvsPatchScalarField& pf : field.boundaryFieldRef())
    {
        const labelUList& cells = pf.patch().faceCells();
        forAll(pf, i)
        {
            const label facei = pf.patch().start() + i;
            const label other =
                pf.coupled() ? across[facei - mesh.nInternalFaces()] : 0;
            pf[i] = value
            (
                facei,
                fixed[cells[i]] || other == 2,
                beside[cells[i]] || other == 1
            );
        }
    }
    return tfield;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::fsi::scalarTransport::diffusion() const
{
    const scalarField& open = geometry_.openness();
    const scalar all = diffusivity_*geometry_.grid().faceArea();
    return perFace
    (
        "Diffusion",
        [&](const label facei, const bool fixed, const bool beside)
        {
            return
                fixed ? 0
              : beside && open[facei] > 0 ? all
              : all*open[facei];
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField>
Foam::fsi::scalarTransport::openFaces() const
{
    const scalarField& now = geometry_.openness();
    const scalarField& last = geometry_.lastOpenness();
    const bool any = surfaces_.anyPermeable();
    return perFace
    (
        "Open",
        [&](const label facei, const bool fixed, const bool)
        {
            const auto* body =
                any ? surfaces_.permeableAt(facei) : nullptr;
            const scalar closed = 1 - min(now[facei], last[facei]);
            return
                fixed ? 0
              : max(now[facei], last[facei])
              + (body ? body->partition*closed : 0);
        }
    );
}


void Foam::fsi::scalarTransport::set
(
    const surfaceScalarField& flux,
    const volScalarField& share,
    fvScalarMatrix& equation
)
{
    const fvMesh& mesh = C_.mesh();
    const auto tscheme(interpolation(flux));
    const tmp<surfaceScalarField> tweights(weightsOf(flux, share, tscheme()));
    const surfaceScalarField& weights = tweights();
    tmp<surfaceScalarField> tdiffusion(diffusion());
    if (surfaces_.anyPermeable())
    {
        inBodies_.set(tdiffusion.ref(), equation.source());
    }
    const surfaceScalarField& D = tdiffusion();
    const scalar perLength = 1/geometry_.grid().spacing();

    scalarField& diagonal = equation.diag();
    scalarField& upper = equation.upper();
    scalarField& lower = equation.lower();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    diagonal = Zero;
    forAll(upper, facei)
    {
        const scalar g = perLength*D[facei];
        const scalar ofOwner = weights[facei]*flux[facei];
        lower[facei] = -(g + ofOwner);
        upper[facei] = flux[facei] - ofOwner - g;
        diagonal[own[facei]] -= lower[facei];
        diagonal[nei[facei]] -= upper[facei];
    }
    forAll(flux.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pf = flux.boundaryField()[patchi];
        const fvsPatchScalarField& pw = weights.boundaryField()[patchi];
        const fvPatchScalarField& pC = C_.boundaryField()[patchi];
        internalCoeffsOf(equation)[patchi] = pf*pC.valueInternalCoeffs(pw);
        boundaryCoeffsOf(equation)[patchi] = -pf*pC.valueBoundaryCoeffs(pw);
        addPatchDiffusion(patchi, D.boundaryField()[patchi], equation);
    }
    if (tscheme().corrected())
    {
        equation += fvc::surfaceIntegrate(flux*tscheme().correction(C_));
    }
}


// ************************************************************************* //
