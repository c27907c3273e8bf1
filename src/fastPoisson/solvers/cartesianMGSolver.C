// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMGSolver.H"
#include "cartesianSolverCache.H"
#include "solverKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cartesianMGSolver, 0);

    lduMatrix::solver::addsymMatrixConstructorToTable<cartesianMGSolver>
        addCartesianMGSolverToTable_;
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianMGSolver::cartesianMGSolver
(
    const word& fieldName,
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const FieldField<Field, scalar>& interfaceIntCoeffs,
    const lduInterfaceFieldPtrsList& interfaces,
    const dictionary& solverControls
)
:
    lduMatrix::solver
    (
        fieldName,
        matrix,
        interfaceBouCoeffs,
        interfaceIntCoeffs,
        interfaces,
        solverControls
    )
{
    checkSolverKeys(solverControls);
    cartesianSolverCache::checkInterfaces(*this, solverControls);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::solverPerformance Foam::fsi::cartesianMGSolver::solve
(
    scalarField& psi,
    const scalarField& source,
    const direction
) const
{
    cartesianMultigrid::loopControls controls;
    controls.tolerance = tolerance_;
    controls.relTol = relTol_;
    controls.minIter = minIter_;
    controls.maxIter = maxIter_;
    return cartesianSolverCache::multigrid(*this, controlDict_).solve
    (
        psi, source, fieldName_, controls
    );
}


// ************************************************************************* //
