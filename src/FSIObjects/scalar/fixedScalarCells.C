// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixedScalarCells.H"
#include "openfoamMesh.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fixedScalarCells::setConvection
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fixedScalarCells::setValues()
{
    forAll(C_, celli)
    {
        if (surfaces_.fixed()[celli])
        {
            C_[celli] = surfaces_.value(celli);
        }
    }
    C_.correctBoundaryConditions();
}


void Foam::fsi::fixedScalarCells::addLinks
(
    const scalar diffusivity,
    fvScalarMatrix& equation
)
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
            const scalar g = diffusivity*link.conductance;
            fixedOne.ofCell += g;
            fixedOne.ofFixed += g;
            links_.append(fixedOne);
            equation.diag()[link.cell] += g;
            equation.source()[link.cell] += g*fixedOne.value;
        }
    }
}


void Foam::fsi::fixedScalarCells::fix
(
    const scalar deltaT,
    fvScalarMatrix& equation
) const
{
    const boolList& fixed = surfaces_.fixed();
    const scalar whole = geometry_.grid().cellVolume()/deltaT;
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


void Foam::fsi::fixedScalarCells::count
(
    const scalarField& taken,
    scalarField& fromSurfaces
) const
{
    for (const fixedLink& link : links_)
    {
        fromSurfaces[surfaces_.group()[link.cell]] +=
            link.ofFixed*link.value - link.ofCell*C_[link.cell];
    }
    forAll(taken, celli)
    {
        if (surfaces_.beside()[celli])
        {
            fromSurfaces[surfaces_.group()[celli]] +=
                taken[celli]*C_[celli];
        }
    }
}


// ************************************************************************* //
