// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianFFTPreconditioner.H"
#include "cartesianSolverCache.H"
#include "openfoamTypes.H"
#include "solverKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cartesianFFTPreconditioner, 0);

    lduMatrix::preconditioner::addsymMatrixConstructorToTable
    <cartesianFFTPreconditioner>
        addCartesianFFTPreconditionerToTable_;
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianFFTPreconditioner::cartesianFFTPreconditioner
(
    const lduMatrix::solver& solver,
    const dictionary& controls
)
:
    lduMatrix::preconditioner(solver),
    transform_(cartesianSolverCache::transform(solver, false))
{
    checkSolverKeys(controls);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cartesianFFTPreconditioner::precondition
(
    solveScalarField& wA,
    const solveScalarField& rA,
    const direction
) const
{
    PrecisionAdaptor<scalar, solveScalar> z(wA);
    const ConstPrecisionAdaptor<scalar, solveScalar> r(rA);
    transform_.precondition(z.ref(), r());
}


// ************************************************************************* //
