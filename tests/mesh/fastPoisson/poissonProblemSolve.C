// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonProblem.H"
#include "fvScalarMatrix.H"
#include "openfoamMesh.H"
#include <ctime>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::fvScalarMatrix>
Foam::fsi::poissonProblem::completeEquation()
{
    tmp<fvScalarMatrix> teqn(equation());
    fvScalarMatrix& eqn = teqn.ref();
    forAll(p_.boundaryField(), patchi)
    {
        const labelUList& cells = eqn.lduAddr().patchAddr(patchi);
        const bool coupled = p_.boundaryField()[patchi].coupled();
        forAll(cells, i)
        {
            eqn.diag()[cells[i]] += internalCoeffsOf(eqn)[patchi][i];
            if (!coupled)
            {
                eqn.source()[cells[i]] += boundaryCoeffsOf(eqn)[patchi][i];
            }
        }
    }
    return teqn;
}


Foam::fsi::poissonResult Foam::fsi::poissonProblem::solve
(
    const string& controls
)
{
    p_.primitiveFieldRef() = 0;
    p_.correctBoundaryConditions();
    IStringStream text(controls);
    const dictionary dict(text);

    tmp<fvScalarMatrix> eqn(equation());
    const std::clock_t start = std::clock();
    const solverPerformance performance = eqn.ref().solve(dict);
    const scalar seconds = scalar(std::clock() - start)/CLOCKS_PER_SEC;

    poissonResult result
    {
        p_.primitiveField(),
        0,
        performance.nIterations(),
        performance.initialResidual(),
        performance.finalResidual(),
        performance.converged(),
        returnReduce(seconds, maxOp<scalar>())
    };
    if (singular_)
    {
        result.mean = gAverage(result.p);
        result.p -= result.mean;
    }
    return result;
}


// ************************************************************************* //
