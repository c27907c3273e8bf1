// SPDX-License-Identifier: GPL-3.0-or-later

#include "carriedScalar.H"
#include "IStringStream.H"
#include "fsiObjects.H"
#include "fvcSurfaceIntegrate.H"
#include "openLaplacian.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceInterpolationScheme<Foam::scalar>>
Foam::fsi::carriedScalar::interpolation(const surfaceScalarField& flux) const
{
    const fvMesh& mesh = C_.mesh();
    const word key("div(phi," + C_.name() + ')');
    if (!schemesOf(mesh).subOrEmptyDict("divSchemes").found(key))
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


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::carriedScalar::weightsOf
(
    const surfaceScalarField& flux,
    const surfaceInterpolationScheme<scalar>& scheme
) const
{
    auto tweights = newTmp<surfaceScalarField>(scheme.weights(C_));
    surfaceScalarField& weights = tweights.ref();
    const scalar least =
        leastShare*objects_.grid().faceArea()*objects_.grid().spacing();
    const auto limit =
        [&](const scalar a, const scalar b, const scalar f, scalar& weight)
    {
        if (min(a, b) < least)
        {
            weight = f >= 0 ? 1 : 0;
        }
    };
    const volScalarField& volume = volumes_.field();
    const labelUList& own = C_.mesh().owner();
    const labelUList& nei = C_.mesh().neighbour();
    forAll(own, facei)
    {
        limit
        (
            volume[own[facei]], volume[nei[facei]], flux[facei], weights[facei]
        );
    }
    forAll(flux.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pf = flux.boundaryField()[patchi];
        if (pf.coupled())
        {
            const fvPatchScalarField& pv = volume.boundaryField()[patchi];
            const scalarField inside(pv.patchInternalField());
            const scalarField across(pv.patchNeighbourField());
            scalarField& ofPatch = weights.boundaryFieldRef()[patchi];
            forAll(pf, i)
            {
                limit(inside[i], across[i], pf[i], ofPatch[i]);
            }
        }
    }
    return tweights;
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::carriedScalar::perFace
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


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::carriedScalar::openFaces() const
{
    const scalarField& now = geometry_.openness();
    const scalarField& last = geometry_.lastOpenness();
    return perFace
    (
        "Open",
        [&](const label facei, const bool fixed, const bool)
        {
            return fixed ? 0 : max(now[facei], last[facei]);
        }
    );
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::carriedScalar::diffusion() const
{
    const scalarField& open = geometry_.openness();
    const scalar all = diffusivity_*objects_.grid().faceArea();
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


void Foam::fsi::carriedScalar::addTransport
(
    const surfaceScalarField& flux,
    fvScalarMatrix& equation
) const
{
    const fvMesh& mesh = C_.mesh();
    const auto tscheme(interpolation(flux));
    const tmp<surfaceScalarField> tweights(weightsOf(flux, tscheme()));
    const surfaceScalarField& weights = tweights();
    const tmp<surfaceScalarField> tdiffusion(diffusion());
    const surfaceScalarField& D = tdiffusion();
    const scalar perLength = 1/objects_.grid().spacing();

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


void Foam::fsi::carriedScalar::setConvection
(
    const wallLink& link,
    const fvScalarMatrix& equation,
    fixedLink& f
) const
{
    // There is no diffusion in these coefficients
    if (link.across < 0)
    {
        const polyBoundaryMesh& patches = C_.mesh().boundaryMesh();
        const label patchi = patches.whichPatch(link.face);
        const label i = link.face - patches[patchi].start();
        f.ofCell = internalCoeffsOf(equation)[patchi][i];
        f.ofFixed = boundaryCoeffsOf(equation)[patchi][i];
        return;
    }
    const bool owns = link.cell < link.across;
    const scalar upper = equation.upper()[link.face];
    const scalar lower = equation.lower()[link.face];
    f.ofCell = owns ? -lower : -upper;
    f.ofFixed = owns ? -upper : -lower;
}


void Foam::fsi::carriedScalar::addSurfaces(fvScalarMatrix& equation)
{
    const fvMesh& mesh = C_.mesh();
    const boolList& fixed = surfaces_.fixed();
    scalarList across;
    swapCoupledCells(mesh, C_.primitiveField(), across);
    boolList fixedAcross;
    swapCoupledCells(mesh, fixed, fixedAcross);
    links_.clear();
    for (const wallLink& link : geometry_.wallLinks())
    {
        const label inBoundary = link.face - mesh.nInternalFaces();
        if (inBoundary < 0 ? fixed[link.across] : fixedAcross[inBoundary])
        {
            fixedLink fixedOne;
            fixedOne.cell = link.cell;
            fixedOne.value =
                inBoundary < 0 ? C_[link.across] : across[inBoundary];
            setConvection(link, equation, fixedOne);
            const scalar g = diffusivity_*link.conductance;
            fixedOne.ofCell += g;
            fixedOne.ofFixed += g;
            links_.append(fixedOne);
            equation.diag()[link.cell] += g;
            equation.source()[link.cell] += g*fixedOne.value;
        }
    }
    const population& bodies = objects_.bodies();
    for (const cellWall& part : geometry_.surfaceParts())
    {
        const label groupi = bodies.objectGroup(part.place.object);
        const auto& surface = surfaces_.all()[groupi];
        if (surface.type == scalarSurfaces::flux)
        {
            const scalar rate = surface.value*mag(part.area);
            equation.source()[part.cell] += rate;
            fromSurfaces_[groupi] += rate;
        }
    }
}


void Foam::fsi::carriedScalar::fixCells(fvScalarMatrix& equation) const
{
    const boolList& fixed = surfaces_.fixed();
    const scalar whole =
        objects_.grid().faceArea()*objects_.grid().spacing()
       /objects_.deltaT();
    scalarField& diagonal = equation.diag();
    scalarField& source = equation.source();
    const labelUList& own = C_.mesh().owner();
    const labelUList& nei = C_.mesh().neighbour();
    forAll(own, facei)
    {
        const bool ofOwner = fixed[own[facei]];
        const bool ofOther = fixed[nei[facei]];
        if (ofOwner || ofOther)
        {
            source[own[facei]] -= equation.upper()[facei]*C_[nei[facei]];
            source[nei[facei]] -= equation.lower()[facei]*C_[own[facei]];
            equation.upper()[facei] = equation.lower()[facei] = 0;
        }
    }
    forAll(internalCoeffsOf(equation), patchi)
    {
        const labelUList& cells = equation.lduAddr().patchAddr(patchi);
        forAll(internalCoeffsOf(equation)[patchi], i)
        {
            if (fixed[cells[i]])
            {
                internalCoeffsOf(equation)[patchi][i] = Zero;
                boundaryCoeffsOf(equation)[patchi][i] = Zero;
            }
        }
    }
    const scalarField all(equation.D());
    forAll(fixed, celli)
    {
        // Cells without fluid keep their value as well
        if (fixed[celli] || all[celli] <= SMALL*whole)
        {
            diagonal[celli] += whole;
            source[celli] = diagonal[celli]*C_[celli];
        }
    }
}


// ************************************************************************* //
