// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedMomentum.H"
#include "dictionaryCheck.H"
#include "fetchAhead.H"
#include "fvmDiv.H"
#include "openfoamMesh.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Flux out of a link's cell through its face and the mean velocity of the two
//  cells; false for faces that are neither internal nor on a coupled patch
static bool faceValues
(
    const surfaceScalarField& flux,
    const volVectorField& U,
    const List<vectorField>& across,
    const wallLink& link,
    scalar& out,
    vector& mean
)
{
    const vector& here = U[link.cell];
    if (link.across >= 0)
    {
        // The owner is the cell of the lower number
        out = link.cell < link.across ? flux[link.face] : -flux[link.face];
        mean = 0.5*(here + U[link.across]);
        return true;
    }
    const polyBoundaryMesh& patches = U.mesh().boundaryMesh();
    const label patchi = patches.whichPatch(link.face);
    const label i = link.face - patches[patchi].start();
    if (across[patchi].empty())
    {
        return false;
    }
    out = flux.boundaryField()[patchi][i];
    mean = 0.5*(here + across[patchi][i]);
    return true;
}


//- Values across the coupled patches; empty lists for others
static List<vectorField> valuesAcross(const volVectorField& U)
{
    List<vectorField> across(U.boundaryField().size());
    forAll(across, patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        if (pU.coupled())
        {
            across[patchi] = pU.patchNeighbourField();
        }
    }
    return across;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedMomentum::addWallConvection
(
    const surfaceScalarField& flux,
    const volVectorField& U,
    const vectorField& wallVelocity,
    vectorField& source
) const
{
    const List<vectorField> across(valuesAcross(U));
    const UList<wallLink>& links = geometry_.wallLinks();
    forAll(links, i)
    {
        const wallLink& later = fetchedAhead(links, i);
        fetchAhead(U[later.cell]);
        fetchAhead(U[max(later.across, 0)]);
        fetchAhead(source[later.cell]);
        fetchAhead(wallVelocity[later.place.nodes[0]]);
        fetchAhead(flux[min(later.face, flux.size() - 1)]);

        const wallLink& link = links[i];
        scalar out = 0;
        vector linear(Zero);
        if (faceValues(flux, U, across, link, out, linear))
        {
            const scalar part = min(0.5/link.wallDistance, 1.0);
            const vector& u = U[link.cell];
            const vector onFace
            (
                u + part*(link.place.interpolate(wallVelocity) - u)
            );
            source[link.cell] -= out*(onFace - linear);
        }
    }
}


void Foam::fsi::immersedMomentum::addDiffusion
(
    const surfaceScalarField& flux,
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
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(upper, facei)
    {
        const scalar g = conductance*fluidFace[facei];
        upper[facei] -= g;
        lower[facei] -= g;
        diagonal[own[facei]] += g - flux[facei];
        diagonal[nei[facei]] += g + flux[facei];
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        addPatchDiffusion
        (
            patchi,
            viscosity*fluidFace.boundaryField()[patchi]*patch.magSf(),
            equation
        );
        const labelUList& cells = patch.faceCells();
        forAll(cells, i)
        {
            diagonal[cells[i]] -= flux.boundaryField()[patchi][i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedMomentum::immersedMomentum
(
    const interfaceGeometry& geometry,
    const faceVelocities& faces,
    const timeRule& rule,
    const dictionary& dict
)
:
    geometry_(geometry),
    faces_(faces),
    rule_(rule),
    wholeFace_
    (
        readChoice(dict, "convection", "wholeFace", {"wholeFace", "openPart"})
     == "wholeFace"
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::fvVectorMatrix> Foam::fsi::immersedMomentum::momentum
(
    const surfaceScalarField& phi,
    volVectorField& U,
    const vectorField& wallVelocity,
    const scalar viscosity,
    const volVectorField& gradient,
    const vector& acceleration
) const
{
    tmp<surfaceScalarField> tflux(rule_.flux(phi));
    if (wholeFace_)
    {
        tflux = faces_.wholeFlux(tflux(), U, wallVelocity);
    }
    tmp<fvVectorMatrix> tequation(fvm::div(tflux(), U, "div(phi,U)"));
    fvVectorMatrix& equation = tequation.ref();
    addDiffusion(tflux(), viscosity, equation);

    const scalar perStep = 1/rule_.step();
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
    if (wholeFace_)
    {
        addWallConvection(tflux(), U, wallVelocity, source);
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
