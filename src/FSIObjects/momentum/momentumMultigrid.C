// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumMultigrid.H"
#include "overRelaxation.H"
#include "sweepControls.H"

#include <algorithm>

namespace
{

//- Factor of the sweeps. 1 needs one more iteration in eight, 1.3 as many
constexpr Foam::scalar relaxation = 1.15;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::momentumMultigrid::momentumMultigrid
(
    const cartesianMesh& grid,
    cartesianMultigrid& multigrid
)
:
    grid_(grid),
    multigrid_(multigrid),
    nDims_(grid.nDims())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::momentumMultigrid::update
(
    fvVectorMatrix& equation,
    redBlackMatrix& matrix
)
{
    // In place: the matrix has taken the equation
    scalarField& upper = equation.upper();
    if (equation.hasLower())
    {
        const scalarField& lower = equation.lower();
        forAll(upper, facei)
        {
            upper[facei] = 0.5*(upper[facei] + lower[facei]);
        }
    }
    scalarField& diagonal = equation.diag();
    forAll(diagonal, celli)
    {
        const scalar* first = matrix.diagonal(matrix.row(celli));
        diagonal[celli] = *std::max_element(first, first + nDims_);
    }

    // A face between ranks has the same mean of the two coefficients on both
    const label nPatches = equation.psi().boundaryField().size();
    FieldField<Field, scalar> across(nPatches);
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        across.set
        (
            patchi,
            0.5
           *(
                internalCoeffsOf(equation)[patchi].component(0)
              + boundaryCoeffsOf(equation)[patchi].component(0)
            )
        );
    }
    multigrid_.update
    (
        equation, across, equation.psi().boundaryField().scalarInterfaces()
    );
}


void Foam::fsi::momentumMultigrid::correct(redBlackMatrix& matrix)
{
    residual_.setSize(matrix.nRows());
    for (label d = 0; d < nDims_; ++d)
    {
        forAll(residual_, celli)
        {
            residual_[celli] = matrix.residual(matrix.row(celli))[d];
        }
        multigrid_.precondition(residual_, residual_, false);
        forAll(residual_, celli)
        {
            matrix.correction(matrix.row(celli))[d] = residual_[celli];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::momentumMultigrid::pays
(
    const population& bodies,
    const fluidProperties& fluid,
    const redBlackMatrix& matrix
)
{
    for (const bodyGroup& group : bodies.groups())
    {
        if (group.movesFreely() && group.hasWalls())
        {
            return false;
        }
    }
    // 1.5 is the factor for dt nu/h^2 of 3 in three dimensions. Some 20 sweeps
    // take as long as a solution by multigrid
    const scalar ofDiffusion = overRelaxation::best(matrix.radii()[0], 0);
    return
        (fluid.shearDependent() ? ofDiffusion : matrix.relaxation()) > 1.5;
}


void Foam::fsi::momentumMultigrid::solve
(
    fvVectorMatrix& equation,
    redBlackMatrix& matrix,
    solverPerformance& result
)
{
    result.solverName() = "fsiMG";
    const sweepControls controls(grid_.mesh(), result.fieldName());
    const scalar norm = matrix.sourceNorm() + VSMALL;
    do
    {
        // Correction by the coarse levels, and two sweeps, each of which
        // returns the residual before it
        matrix.startCorrection(norm);
        if (result.nIterations() > 0)
        {
            if (result.nIterations() == 1)
            {
                update(equation, matrix);
            }
            correct(matrix);
        }
        const scalar before = matrix.sweep(relaxation);
        if (result.nIterations() == 0)
        {
            result.initialResidual() = before;
        }
        result.finalResidual() = matrix.sweep(relaxation);
        matrix.addCorrection();
        overRelaxation::checkConverges
        (
            result.finalResidual(), result.nIterations()
        );
    } while (controls.more(result));
}


// ************************************************************************* //
