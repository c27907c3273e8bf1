// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedMomentum.H"
#include "fetchAhead.H"
#include "fvcSurfaceIntegrate.H"
#include "openfoamMesh.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceInterpolationScheme<Foam::vector>>
Foam::fsi::immersedMomentum::interpolation(const surfaceScalarField& flux)
{
    const fvMesh& mesh = flux.mesh();
    ITstream& scheme = divSchemeOf(mesh, "div(phi,U)");
    const word kind(scheme);
    if (kind != "Gauss")
    {
        FatalIOErrorInFunction(schemesOf(mesh))
            << "Entry 'div(phi,U)' or 'default' of divSchemes is " << kind
            << " but must be Gauss with an interpolation, as Gauss linear"
            << exit(FatalIOError);
    }
    return surfaceInterpolationScheme<vector>::New(mesh, flux, scheme);
}


void Foam::fsi::immersedMomentum::setFaces
(
    const surfaceScalarField& flux,
    const surfaceScalarField& weights,
    const scalar viscosity,
    fvVectorMatrix& equation
) const
{
    const fvMesh& mesh = flux.mesh();
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    const scalar conductance =
        viscosity*geometry_.grid().faceArea()/geometry_.grid().spacing();

    scalarField& diagonal = equation.diag();
    scalarField& upper = equation.upper();
    scalarField& lower = equation.lower();
    diagonal = Zero;
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(upper, facei)
    {
        // As the sum of its coefficients is without u div(flux)
        const scalar g = conductance*fluidFace[facei];
        const scalar ofOwner = weights[facei]*flux[facei];
        lower[facei] = -(g + ofOwner);
        upper[facei] = flux[facei] - ofOwner - g;
        diagonal[own[facei]] -= upper[facei];
        diagonal[nei[facei]] -= lower[facei];
    }
}


void Foam::fsi::immersedMomentum::setPatches
(
    const surfaceScalarField& flux,
    const surfaceScalarField& weights,
    const scalar viscosity,
    fvVectorMatrix& equation
) const
{
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    scalarField& diagonal = equation.diag();
    forAll(flux.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pf = flux.boundaryField()[patchi];
        const fvsPatchScalarField& pw = weights.boundaryField()[patchi];
        const fvPatchVectorField& pU = equation.psi().boundaryField()[patchi];
        internalCoeffsOf(equation)[patchi] = pf*pU.valueInternalCoeffs(pw);
        boundaryCoeffsOf(equation)[patchi] = -pf*pU.valueBoundaryCoeffs(pw);
        addPatchDiffusion
        (
            patchi,
            viscosity*fluidFace.boundaryField()[patchi]*pf.patch().magSf(),
            equation
        );
        const labelUList& cells = pf.patch().faceCells();
        forAll(cells, i)
        {
            diagonal[cells[i]] -= pf[i];
        }
    }
}


Foam::tmp<Foam::fvVectorMatrix> Foam::fsi::immersedMomentum::transport
(
    const surfaceScalarField& flux,
    volVectorField& U,
    const scalar viscosity
) const
{
    auto tequation =
        newTmp<fvVectorMatrix>(U, flux.dimensions()*U.dimensions());
    const tmp<surfaceInterpolationScheme<vector>> tscheme(interpolation(flux));
    const tmp<surfaceScalarField> tweights(tscheme().weights(U));
    setFaces(flux, tweights(), viscosity, tequation.ref());
    setPatches(flux, tweights(), viscosity, tequation.ref());
    if (tscheme().corrected())
    {
        tequation.ref() +=
            fvc::surfaceIntegrate(flux*tscheme().correction(U));
    }
    return tequation;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedMomentum::immersedMomentum
(
    const interfaceGeometry& geometry,
    const timeRule& rule
)
:
    geometry_(geometry),
    rule_(rule),
    cut_(geometry)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::fvVectorMatrix> Foam::fsi::immersedMomentum::momentum
(
    const surfaceScalarField& flux,
    volVectorField& U,
    const scalar viscosity,
    const volVectorField& gradient,
    const vector& acceleration
)
{
    cut_.begin(flux);
    tmp<fvVectorMatrix> tequation(transport(flux, U, viscosity));
    fvVectorMatrix& equation = tequation.ref();
    const scalar perStep = 1/rule_.length().tau;
    const scalarField& V = U.mesh().V();
    const tmp<vectorField> tlast(rule_.start(U));
    const vectorField& last = tlast();
    scalarField& diagonal = equation.diag();
    vectorField& source = equation.source();
    forAll(source, celli)
    {
        diagonal[celli] += V[celli]*perStep;
        source[celli] +=
            V[celli]*(perStep*last[celli] + acceleration - gradient[celli]);
    }
    return tequation;
}


void Foam::fsi::immersedMomentum::constrain(fvVectorMatrix& UEqn) const
{
    // As setValues does for the solid cells, which goes through each cell's
    // faces, in 2D two empty ones
    const boolList& fluid = geometry_.fluidCell();
    const vectorField& U = UEqn.psi().primitiveField();
    const scalarField& diagonal = UEqn.diag();
    scalarField& upper = UEqn.upper();
    scalarField& lower = UEqn.lower();
    vectorField& source = UEqn.source();
    const UList<wallLink>& links = geometry_.wallLinks();
    forAll(links, i)
    {
        const wallLink& later = fetchedAhead(links, i);
        fetchAhead(source[later.cell]);
        fetchAhead(U[max(later.across, 0)]);
        fetchAhead(upper[min(later.face, upper.size() - 1)]);
        fetchAhead(lower[min(later.face, lower.size() - 1)]);

        const wallLink& link = links[i];
        if (link.across >= 0)
        {
            // The owner is the cell of the lower number
            source[link.cell] -=
                (link.cell < link.across ? upper : lower)[link.face]
               *U[link.across];
            upper[link.face] = lower[link.face] = 0;
        }
    }
    const labelUList& firstFace = UEqn.lduAddr().ownerStartAddr();
    forAll(fluid, celli)
    {
        if (!fluid[celli])
        {
            source[celli] = U[celli]*diagonal[celli];
            for (label i = firstFace[celli]; i < firstFace[celli + 1]; ++i)
            {
                upper[i] = lower[i] = 0;
            }
        }
    }
    forAll(internalCoeffsOf(UEqn), patchi)
    {
        const labelUList& cells = UEqn.lduAddr().patchAddr(patchi);
        forAll(internalCoeffsOf(UEqn)[patchi], i)
        {
            if (!fluid[cells[i]])
            {
                internalCoeffsOf(UEqn)[patchi][i] = Zero;
                boundaryCoeffsOf(UEqn)[patchi][i] = Zero;
            }
        }
    }
}


// ************************************************************************* //
