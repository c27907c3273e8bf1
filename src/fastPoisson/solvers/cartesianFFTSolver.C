// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianFFTSolver.H"
#include "cartesianSolverCache.H"
#include "solverKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cartesianFFTSolver, 0);

    lduMatrix::solver::addsymMatrixConstructorToTable<cartesianFFTSolver>
        addCartesianFFTSolverToTable_;
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianFFTSolver::cartesianFFTSolver
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

Foam::solverPerformance Foam::fsi::cartesianFFTSolver::solve
(
    scalarField& psi,
    const scalarField& source,
    const direction
) const
{
    return cartesianSolverCache::transform(*this, true).solve
    (
        psi, source, fieldName_, tolerance_, relTol_, minIter_, maxIter_
    );
}


// ************************************************************************* //
