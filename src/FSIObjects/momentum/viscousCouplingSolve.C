// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"
#include "linkForces.H"
#include "shortWaveStress.H"
#include "sweepControls.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::finish
(
    const volVectorField& U,
    const nodeLayout::groupNodal& predicted,
    nodeLayout::groupNodal& velocity,
    vectorField& force
)
{
    linkForce_.reset(nodalVelocity_.size());
    addLinkForce
    (
        geometry_, fluid_.dynamicViscosity(), U, nodalVelocity_, linkForce_
    );
    partialForces all(linkForce_);
    films_.addForce(fluid_.density, nodalVelocity_, all);
    all.mine() += given_;
    force = all.collectWalls(bodies_.ranks());
    addShortWaveForce
    (
        bodies_, fluid_, geometry_.grid().thickness(), relative_,
        nodalVelocity_, force
    );
    force += strainForce_;
    addTransposedForce
    (
        transposed_,
        bodies_.surfaces().pointStart(),
        nodalVelocity_,
        force
    );

    velocity = predicted;
    bodies_.layout().toGroups(force, groupForce_);
    forAll(velocity, groupi)
    {
        if (responses_[groupi])
        {
            responses_[groupi]->finish(groupForce_[groupi], velocity[groupi]);
        }
    }
}


void Foam::fsi::viscousCoupling::sweep
(
    solverPerformance& result,
    nodeLayout::groupNodal& v
)
{
    const sweepControls end(geometry_.grid().mesh(), result.fieldName());
    setWalls(v);
    const scalar norm = matrix_.sourceNorm() + VSMALL;
    startCorrection(norm);
    // Cells with little viscosity may be beside others with much of it
    const scalar largest =
        fluid_.shearDependent()
      ? overRelaxation::best(1, matrix_.radii()[1])
      : 2;
    relaxation_.start(matrix_.relaxation(), largest);
    do
    {
        if (matrix_.exhausted())
        {
            matrix_.addCorrection();
            links_.keepValues();
            setWalls(v);
            startCorrection(norm);
        }
        const scalar factor = relaxation_.factor();
        const scalar inFilms =
            films_.relax(nodalVelocity_, factor, matrix_.correctionScale());
        result.finalResidual() = matrix_.sweep(factor, inFilms);
        if (result.nIterations() == 0)
        {
            result.initialResidual() = result.finalResidual();
        }
        overRelaxation::checkConverges
        (
            result.finalResidual(), result.nIterations()
        );
        overRelax(v);
        moveWalls(v);
        relaxation_.observe(result.finalResidual());
    } while (end.more(result));
    matrix_.addCorrection();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::solve
(
    fvVectorMatrix& UEqn,
    volVectorField& U,
    const stepLength& step,
    const expectedChange& change,
    const nodeLayout::groupNodal& predicted,
    const vectorField& given,
    nodeLayout::groupNodal& velocity,
    vectorField& force
)
{
    given_ = given;
    updateResponses(step, predicted);
    setMatrix(UEqn, change);
    solverPerformance result("fsiSOR", U.name());
    nodeLayout::groupNodal boundary
    (
        bodies_.layout().boundaryOf(predicted)
    );
    setWalls(boundary);
    films_.set(geometry_.betweenSurfaces(), fluid_.viscosity, nodalVelocity_);
    if (momentumMultigrid::pays(bodies_, fluid_, matrix_))
    {
        multigrid_.solve(UEqn, matrix_, result);
    }
    else
    {
        nodeVelocity(boundary);
        sweep(result, boundary);
    }
    log_.solved(result);
    keepResiduals(U.mesh(), ofVector(result));
    overRelaxation::checkEnd(result);

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
    partialForces beyond;
    beyond.mine() = -linkForce_.mine();
    addLinkForce
    (
        geometry_, fluid_.dynamicViscosity(), U, nodalVelocity_, beyond
    );
    force = beyond.collectWalls(bodies_.ranks());
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
        overRelaxation::checkConverges(residual, nSweeps);
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
            geometry_.fluidCell(),
            source,
            factor,
            U.primitiveFieldRef()
        )
    );
    U.correctBoundaryConditions();
    return squares;
}


// ************************************************************************* //
