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
    const scalar size =
        max(residual/nMeshCells_, VSMALL);

    multigridLevel& finest = hierarchy_.finest();
    scaled(A, 1/size, r_.cdata(), finest.b().data());
    hierarchy_.cycle();

    const scalar factor = size/norm_;
    const scalar rz =
        total(factor*dotProduct(A, r_.cdata(), finest.x().cdata()));
    const scalar beta = oldProduct > 0 ? rz/oldProduct : 0;
    pAp =
        total
        (
            sum_.multiplyNext(factor, finest.x().cdata(), beta, p_, Ap_)
        );
    return rz;
}


void Foam::fsi::cartesianMultigrid::iterate
(
    solverPerformance& result,
    const scalar factor,
    const loopControls& controls
) const
{
    scalar rz = 0;
    scalar least = result.initialResidual();
    label nInVain = 0;
    // Solution of the least residual while others are in vain: where only
    // rounding errors are left, each may double the level of a closed part
    scalarField best;
    do
    {
        scalar pAp = 0;
        rz = nextDirection(factor*result.finalResidual(), rz, pAp);
        if (result.checkSingularity(mag(pAp)/factor) || mag(pAp) < nothing*rz)
        {
            break;
        }
        const scalar alpha = rz/pAp;
        result.finalResidual() =
            total
            (
                updateSolution
                (
                    matrix_.A(), alpha, p_.cdata(), Ap_.cdata(),
                    x_.data(), r_.data()
                )
            )/factor;
        nInVain = result.finalResidual() < least ? 0 : nInVain + 1;
        if (nInVain == 1)
        {
            best = x_ - alpha*p_;
        }
        least = min(least, result.finalResidual());
    } while
    (
        (
            ++result.nIterations() < controls.maxIter
         && nInVain < mostInVain
         && !result.checkConvergence(controls.tolerance, controls.relTol)
        )
     || result.nIterations() < controls.minIter
    );
    if (nInVain >= mostInVain)
    {
        x_ = best;
        result.finalResidual() = least;
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
    sum_.multiply(x_, Ap_);
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

    if
    (
        controls.minIter > 0
     || !result.checkConvergence(controls.tolerance, controls.relTol)
    )
    {
        iterate(result, factor, controls);
        transfer.toCells(x_.cdata(), 1, psi);
    }
    return result;
}


// ************************************************************************* //
