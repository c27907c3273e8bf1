// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"
#include "dictionaryCheck.H"
#include "linkForces.H"
#include "openfoamMesh.H"
#include "shortWaveStress.H"
#include "sumOverRanks.H"
#include "solverPerformance.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Stop before the squares of the sweeps' numbers overflow
static void checkConverges
(
    const scalar residual,
    const label nSweeps,
    const scalar limit = 1e15
)
{
    if (!(residual < limit))
    {
        FatalErrorInFunction
            << "The velocity's sweeps diverge: residual " << residual
            << " after " << nSweeps
            << ". Take a smaller deltaT (Courant number below 1) or"
            << " adjustTimeStep with maxCo; give very soft bodies a viscosity"
            << " (material)" << exit(FatalError);
    }
}


//- Say so if the sweeps ended before the tolerance; stop where zero would have
//  been a better velocity
static void checkEnd(const solverPerformance& result)
{
    if (!result.converged())
    {
        checkConverges(result.finalResidual(), result.nIterations(), 1);
        WarningInFunction
            << "The velocity's sweeps did not converge: residual "
            << result.finalResidual() << " after " << result.nIterations()
            << " (maxIter in fvSolution). Take a smaller deltaT" << endl;
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::finish
(
    const volVectorField& U,
    const fsiSystem::groupNodal& predicted,
    fsiSystem::groupNodal& velocity,
    vectorField& force
)
{
    force.setSize(nodalVelocity_.size());
    force = Zero;
    addLinkForce(system_, U, nodalVelocity_, force);
    linkForce_ = force;
    sumOverRanks(force);
    addShortWaveForce(system_, nodalVelocity_, force);
    force += strainForce_;
    addTransposedForce
    (
        transposed_,
        system_.objects.surfaces().pointStart(),
        nodalVelocity_,
        force
    );

    velocity = predicted;
    system_.objects.layout().toGroups(force, groupForce_);
    forAll(velocity, groupi)
    {
        if (responses_[groupi])
        {
            responses_[groupi]->finish
            (
                groupForce_[groupi],
                velocity[groupi]
            );
        }
    }
}


void Foam::fsi::viscousCoupling::sweep
(
    solverPerformance& result,
    fsiSystem::groupNodal& v
)
{
    const dictionary& controls =
        solverControls(system_.grid.mesh(), result.fieldName());
    const label maxIter = readAtLeast(controls, "maxIter", 1000, 1);
    const scalar tolerance =
        controls.lookupOrDefault<scalar>("tolerance", 1e-7);
    const scalar relTol = controls.lookupOrDefault<scalar>("relTol", 0);

    setWalls(v);
    const scalar norm = matrix_.sourceNorm() + VSMALL;
    startCorrection(norm);
    relaxation_.start(matrix_.relaxation());
    do
    {
        if (matrix_.exhausted())
        {
            matrix_.addCorrection();
            links_.keepValues();
            setWalls(v);
            startCorrection(norm);
        }
        result.finalResidual() = matrix_.sweep(relaxation_.factor());
        if (result.nIterations() == 0)
        {
            result.initialResidual() = result.finalResidual();
        }
        checkConverges(result.finalResidual(), result.nIterations());
        overRelax(v);
        moveWalls(v);
        relaxation_.observe(result.finalResidual());
    } while
    (
        ++result.nIterations() < maxIter
     && !result.checkConvergence(tolerance, relTol)
    );
    matrix_.addCorrection();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::solve
(
    fvVectorMatrix& UEqn,
    volVectorField& U,
    const expectedChange& change,
    const fsiSystem::groupNodal& predicted,
    fsiSystem::groupNodal& velocity,
    vectorField& force
)
{
    solverPerformance result("fsiSOR", U.name());

    updateResponses(predicted);
    setMatrix(UEqn, change);
    fsiSystem::groupNodal boundary
    (
        system_.objects.layout().boundaryOf(predicted)
    );
    nodeVelocity(boundary);
    sweep(result, boundary);
    system_.log->solved(result);
    // All components are swept together
    keepResiduals
    (
        U.mesh(),
        SolverPerformance<vector>
        (
            result.solverName(),
            result.fieldName(),
            vector::uniform(result.initialResidual()),
            vector::uniform(result.finalResidual()),
            labelVector::uniform(result.nIterations()),
            result.converged()
        )
    );
    checkEnd(result);

    matrix_.get(U.primitiveFieldRef());
    U.correctBoundaryConditions();
    finish(U, predicted, velocity, force);
}


void Foam::fsi::viscousCoupling::linkForceBeyond
(
    const volVectorField& U,
    vectorField& force
) const
{
    force = -linkForce_;
    addLinkForce(system_, U, nodalVelocity_, force);
    sumOverRanks(force);
}


Foam::FixedList<Foam::scalar, 2> Foam::fsi::viscousCoupling::addResponse
(
    const vectorField& source,
    const vectorField& guess,
    const scalar factor,
    volVectorField& U
)
{
    const dictionary& controls = solverControls(U.mesh(), U.name());
    const label maxIter = readAtLeast(controls, "responseMaxIter", 5, 1);
    const scalar tolerance =
        readPositive(controls, "responseTolerance", 0.05);

    // A sweep tells the residual before it; the next one falls as fast
    const bool fromZero = guess.empty();
    const scalar norm =
        VSMALL
      + (
            fromZero
          ? matrix_.startFromZero(source)
          : matrix_.startFrom(source, guess)
        );
    scalar before = fromZero ? 1 : 0;
    for (label nSweeps = fromZero ? 1 : 0; nSweeps < maxIter; ++nSweeps)
    {
        if (matrix_.exhausted())
        {
            matrix_.addCorrection();
            matrix_.startCorrection(norm);
        }
        const scalar residual = matrix_.sweep(1);
        checkConverges(residual, nSweeps);
        if (sqr(residual) <= tolerance*before)
        {
            break;
        }
        before = residual;
    }
    const FixedList<scalar, 2> squares
    (
        matrix_.addTo
        (
            system_.geometry.fluidCell(),
            source,
            factor,
            U.primitiveFieldRef()
        )
    );
    U.correctBoundaryConditions();
    return squares;
}


// ************************************************************************* //
