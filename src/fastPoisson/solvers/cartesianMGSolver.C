// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMGSolver.H"
#include "cartesianMultigridCache.H"

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
    const wordHashSet linear({"cyclic", "processor", "processorCyclic"});
    forAll(interfaces, patchi)
    {
        if (interfaces.set(patchi) && !linear.found(interfaces[patchi].type()))
        {
            FatalIOErrorInFunction(solverControls)
                << "Field " << fieldName << " has a coupled patch of type "
                << interfaces[patchi].type() << ", which this solver does not"
                << " know. Use 'solver PCG; preconditioner cartesianMG;'"
                << " or GAMG." << exit(FatalIOError);
        }
    }
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
    return cartesianMultigridCache::updated(*this, controlDict_).solve
    (
        psi, source, fieldName_, controls
    );
}


// ************************************************************************* //
