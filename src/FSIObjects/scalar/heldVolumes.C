// SPDX-License-Identifier: GPL-3.0-or-later

#include "heldVolumes.H"
#include "openLaplacian.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- values -= dt sum of the fluxes out of each cell
static void subtractFluxes
(
    const surfaceScalarField& flux,
    const scalar dt,
    scalarField& values
)
{
    scalarField change(values.size(), Zero);
    subtractOutflow(flux, change);
    values += dt*change;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::solverPerformance Foam::fsi::quietly
(
    fvScalarMatrix& equation,
    const dictionary& controls
)
{
    const int printed = solverPerformance::debug;
    solverPerformance::debug = 0;
    const solverPerformance result(equation.solve(controls));
    solverPerformance::debug = printed;
    return result;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::heldVolumes::solve
(
    const scalarField& target,
    const scalarField& left,
    const surfaceScalarField& open
)
{
    const fvMesh& mesh = grid_.mesh();
    const scalar whole = grid_.cellVolume();
    const scalar conductance = sqr(reach)*whole;
    excess_.primitiveFieldRef() = Zero;
    excess_.correctBoundaryConditions();

    fvScalarMatrix equation(excess_, dimVolume);
    scalarField& diagonal = equation.diag();
    scalarField& upper = equation.upper();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    diagonal = target;
    forAll(upper, facei)
    {
        const scalar k = conductance*open[facei];
        upper[facei] = -k;
        diagonal[own[facei]] += k;
        diagonal[nei[facei]] += k;
    }
    forAll(open.boundaryField(), patchi)
    {
        const fvsPatchScalarField& po = open.boundaryField()[patchi];
        if (po.coupled())
        {
            addPatchDiffusion
            (
                patchi, conductance*grid_.spacing()*po, equation
            );
        }
        else
        {
            internalCoeffsOf(equation)[patchi] = Zero;
            boundaryCoeffsOf(equation)[patchi] = Zero;
        }
    }
    equation.source() = left - target;

    // Cells without open faces
    const scalarField all(equation.D());
    forAll(all, celli)
    {
        if (all[celli] <= SMALL*whole)
        {
            diagonal[celli] = whole;
            equation.source()[celli] = 0;
        }
    }

    dictionary controls;
    controls.add("solver", word("PCG"));
    controls.add("preconditioner", word("DIC"));
    controls.add("tolerance", tolerance);
    controls.add("relTol", scalar(0));
    quietly(equation, controls);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::heldVolumes::heldVolumes
(
    const cartesianMesh& grid,
    const word& name,
    const scalarField& open
)
:
    grid_(grid),
    volume_
    (
        IOobject
        (
            name,
            nameOf(grid.mesh().time()),
            grid.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        grid.mesh(),
        dimensionedScalar("value", dimVolume, -1),
        zeroGradientFvPatchScalarField::typeName
    ),
    excess_
    (
        IOobject(name + "Excess", nameOf(grid.mesh().time()), grid.mesh()),
        grid.mesh(),
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    )
{
    forAll(open, celli)
    {
        if (volume_[celli] == -1)
        {
            volume_[celli] = open[celli];
        }
    }
    last_ = volume_.primitiveField();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::fsi::heldVolumes::advance
(
    const scalarField& target,
    const surfaceScalarField& open,
    const boolList& free,
    surfaceScalarField& flux
)
{
    const scalar dt = grid_.mesh().time().deltaTValue();
    last_ = volume_.primitiveField();
    scalarField left(last_);
    subtractFluxes(flux, dt, left);
    auto ttaken = newTmp<scalarField>(left.size(), Zero);
    scalarField& taken = ttaken.ref();
    forAll(left, celli)
    {
        if (free[celli])
        {
            taken[celli] = target[celli] - left[celli];
            left[celli] = target[celli];
        }
    }
    solve(target, left, open);

    const scalar perExcess = sqr(reach)*grid_.cellVolume()/dt;
    const labelUList& own = grid_.mesh().owner();
    const labelUList& nei = grid_.mesh().neighbour();
    forAll(own, facei)
    {
        flux[facei] +=
            perExcess*open[facei]*(excess_[own[facei]] - excess_[nei[facei]]);
    }
    forAll(flux.boundaryField(), patchi)
    {
        fvsPatchScalarField& pf = flux.boundaryFieldRef()[patchi];
        const fvPatchScalarField& ps = excess_.boundaryField()[patchi];
        if (pf.coupled())
        {
            pf +=
                perExcess*open.boundaryField()[patchi]
               *(ps.patchInternalField() - ps.patchNeighbourField());
        }
    }

    scalarField& volume = volume_.primitiveFieldRef();
    volume = last_ + taken;
    subtractFluxes(flux, dt, volume);
    volume_.correctBoundaryConditions();
    return ttaken;
}


// ************************************************************************* //
