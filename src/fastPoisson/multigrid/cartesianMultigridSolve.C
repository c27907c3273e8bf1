// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMultigrid.H"
#include "stencilProducts.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::cartesianMultigrid::nextDirection
(
    const scalar residual,
    const scalar oldProduct,
    scalar& pAp
) const
{
    // Single precision needs values of order one
    const stencil<double>& A = matrix_.A();
    const scalar size = max(residual/nMeshCells_, VSMALL);

    multigridLevel& finest = hierarchy_.finest();
    scaled(A, 1/size, r_.cdata(), finest.b().data());
    hierarchy_.cycle();

    const scalar factor = size/norm_;
    const scalar rz =
        total(factor*dotProduct(A, r_.cdata(), finest.x().cdata()));
    const scalar beta = oldProduct > 0 ? rz/oldProduct : 0;
    pAp = total(sum_.multiplyNext(factor, finest.x().cdata(), beta, p_, Ap_));
    return rz;
}


bool Foam::fsi::cartesianMultigrid::isExact
(
    solverPerformance& result,
    const scalar taken,
    const scalar fall,
    scalar& energy
)
{
    energy += ofChange*taken;
    const scalar change = sqrt(taken/energy);
    if (result.nIterations() == 0)
    {
        result.initialResidual() = max(result.initialResidual(), change);
    }
    result.finalResidual() = max(result.finalResidual(), change*fall);
    return change*fall < roundingError && result.checkConvergence(GREAT, 0);
}


void Foam::fsi::cartesianMultigrid::iterate
(
    solverPerformance& result,
    const scalar factor,
    scalar energy,
    const loopControls& controls
) const
{
    scalar rz = 0;
    scalar residual = factor*result.initialResidual();
    scalar least = residual;
    label nInVain = 0;
    bool exact = false;
    // Solution of the least residual while others are in vain: where only
    // rounding errors are left, each may double the level of a closed part
    scalarField best;
    do
    {
        scalar pAp = 0;
        rz = nextDirection(residual, rz, pAp);
        if
        (
            result.checkSingularity(mag(pAp)/factor)
         || (pAp <= nothing*mag(rz) && result.checkConvergence(GREAT, 0))
        )
        {
            break;
        }
        const scalar alpha = rz/pAp;
        const scalar before = residual;
        residual =
            total
            (
                updateSolution
                (
                    matrix_.A(), alpha, p_.cdata(), Ap_.cdata(),
                    x_.data(), r_.data()
                )
            );
        result.finalResidual() = residual/factor;
        if (controls.ofFlow())
        {
            exact = isExact(result, alpha*rz, residual/before, energy);
        }
        nInVain = residual < least ? 0 : nInVain + 1;
        if (nInVain == 1)
        {
            best = x_ - alpha*p_;
        }
        least = min(least, residual);
    } while
    (
        (
            ++result.nIterations() < controls.maxIter
         && nInVain < mostInVain
         && !exact
         && !result.checkConvergence(controls.tolerance, controls.relTol)
        )
     || result.nIterations() < controls.minIter
    );
    if (nInVain >= mostInVain)
    {
        x_ = best;
        result.finalResidual() = least/factor;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::solverPerformance Foam::fsi::cartesianMultigrid::solve
(
    scalarField& psi,
    const scalarField& source,
    const word& fieldName,
    const loopControls& controls,
    const addedTerm* term
) const
{
    solverPerformance result("cartesianMG", fieldName);
    const cellTransfer& transfer = lattice_.transfer();
    sum_.set(term);

    transfer.toBlock(psi, 1, x_.data());
    transfer.toBlock(source, matrix_.sign(), r_.data());
    const scalar xAx = sum_.multiply(x_, Ap_);
    const scalar energy =
        controls.ofFlow() ? total(controls.energy + ofStart*xAx) : 0;
    const scalar factor =
        matrix_.normFactor(Ap_, r_, total(sum(psi))/nMeshCells_);

    // p_ is set to zero for the first direction
    p_ = 0;
    const scalar residual =
        total
        (
            updateSolution
            (
                matrix_.A(), 1, p_.cdata(), Ap_.cdata(),
                x_.data(), r_.data()
            )
        );
    if (!term || term->keepsLevel())
    {
        // Remove the level of the source and of the rounding errors of A x
        matrix_.removeLevel(r_);
    }
    result.initialResidual() = residual/factor;
    result.finalResidual() = result.initialResidual();

    // The velocity's error is known after an iteration
    if
    (
        !result.checkConvergence(controls.tolerance, controls.relTol)
     || controls.minIter > 0
     || (controls.ofFlow() && residual > 0)
    )
    {
        iterate(result, factor, energy, controls);
        transfer.toCells(x_.cdata(), 1, psi);
    }
    return result;
}


// ************************************************************************* //
