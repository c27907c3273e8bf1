// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumMultigrid.H"
#include "overRelaxation.H"
#include "sumOverRanks.H"
#include "sweepControls.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::momentumMultigrid::momentumMultigrid(const cartesianMesh& grid)
:
    grid_(grid),
    nDims_(grid.nDims())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::momentumMultigrid::update
(
    const fvVectorMatrix& equation,
    redBlackMatrix& matrix
)
{
    if (!multigrid_.valid())
    {
        const fvMesh& mesh = grid_.mesh();
        multigrid_.reset(new cartesianMultigrid(mesh, dictionary::null));
        residual_.setSize(mesh.nCells());
        answer_.setSize(mesh.nCells());
    }
    lduMatrix symmetric(equation.mesh());
    symmetric.upper() = equation.upper();
    if (equation.hasLower())
    {
        symmetric.upper() = 0.5*(equation.upper() + equation.lower());
    }
    scalarField& diagonal = symmetric.diag();
    diagonal.setSize(residual_.size());
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
    multigrid_->update
    (
        symmetric, across, equation.psi().boundaryField().scalarInterfaces()
    );
}


void Foam::fsi::momentumMultigrid::correct
(
    const scalar part,
    redBlackMatrix& matrix
)
{
    cartesianMultigrid::loopControls controls;
    controls.tolerance = 0;
    controls.relTol = part;
    controls.maxIter = 20;
    for (label d = 0; d < nDims_; ++d)
    {
        forAll(residual_, celli)
        {
            residual_[celli] = matrix.residual(matrix.row(celli))[d];
        }
        answer_ = 0;
        multigrid_->solve(answer_, residual_, "U", controls);
        forAll(answer_, celli)
        {
            matrix.correction(matrix.row(celli))[d] = answer_[celli];
        }
    }
}


Foam::scalar Foam::fsi::momentumMultigrid::residualNorm
(
    redBlackMatrix& matrix
) const
{
    scalar squares = 0;
    for (label row = 0; row < matrix.nRows(); ++row)
    {
        const floatScalar* residual = matrix.residual(row);
        for (label d = 0; d < nDims_; ++d)
        {
            squares += sqr(residual[d]);
        }
    }
    return Foam::sqrt(overRanks(squares, sumOp<scalar>()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::momentumMultigrid::pays
(
    const population& bodies,
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
    return matrix.relaxation() > 1.5;
}


void Foam::fsi::momentumMultigrid::solve
(
    const fvVectorMatrix& equation,
    redBlackMatrix& matrix,
    solverPerformance& result
)
{
    result.solverName() = "fsiMG";
    const sweepControls controls(grid_.mesh(), result.fieldName());
    update(equation, matrix);
    const scalar norm = matrix.sourceNorm() + VSMALL;
    do
    {
        matrix.startCorrection(norm);
        scalar& residual = result.finalResidual();
        if (result.nIterations() == 0)
        {
            residual = result.initialResidual() = residualNorm(matrix);
        }

        // The sweep returns the residual before it
        const scalar part = 0.3*controls.tolerance/(residual + VSMALL);
        correct(min(max(part, scalar(1e-3)), scalar(0.1)), matrix);
        residual = matrix.sweep(1);
        matrix.addCorrection();
        overRelaxation::checkConverges(residual, result.nIterations());
    } while (controls.more(result));
}


// ************************************************************************* //
