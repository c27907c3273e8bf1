// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMGPreconditioner.H"
#include "cartesianSolverCache.H"
#include "openfoamTypes.H"
#include "solverKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cartesianMGPreconditioner, 0);

    lduMatrix::preconditioner::addsymMatrixConstructorToTable
    <cartesianMGPreconditioner>
        addCartesianMGPreconditionerToTable_;
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianMGPreconditioner::cartesianMGPreconditioner
(
    const lduMatrix::solver& solver,
    const dictionary& controls
)
:
    lduMatrix::preconditioner(solver),
    multigrid_(cartesianSolverCache::multigrid(solver, controls))
{
    checkSolverKeys(controls);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cartesianMGPreconditioner::precondition
(
    solveScalarField& wA,
    const solveScalarField& rA,
    const direction
) const
{
    PrecisionAdaptor<scalar, solveScalar> z(wA);
    const ConstPrecisionAdaptor<scalar, solveScalar> r(rA);
    multigrid_.precondition(z.ref(), r());
}


// ************************************************************************* //
