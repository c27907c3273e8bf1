// SPDX-License-Identifier: GPL-3.0-or-later

#include "overRelaxation.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::overRelaxation::better(const scalar rate) const
{
    const scalar mu2 = sqr(rate + factor_ - 1)/(sqr(factor_)*rate);
    return min(best(Foam::sqrt(mu2), 0), largest_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::overRelaxation::best
(
    const scalar alpha,
    const scalar beta
)
{
    const scalar squares = max(1 - sqr(alpha), scalar(0)) + sqr(beta);
    return 2/(1 + Foam::sqrt(squares));
}


void Foam::fsi::overRelaxation::start
(
    const scalar smallest,
    const scalar largest
)
{
    largest_ = min(largest, 1.95);
    smallest_ = min(smallest, scalar(largestStart_));
    factor_ = smallest_;
    residual_ = 0;
    sweeps_ = 0;
}


void Foam::fsi::overRelaxation::observe(const scalar residual)
{
    if (residual_ <= 0 || sweeps_ < 0)
    {
        residual_ = residual;
        sweeps_ = min(sweeps_ + 1, label(0));
        return;
    }
    if (++sweeps_ < nSweeps_ || residual <= 0)
    {
        return;
    }
    const scalar rate = pow(residual/residual_, 1.0/nSweeps_);
    const scalar old = factor_;
    if (rate >= 1)
    {
        factor_ = smallest_ + 0.5*(factor_ - smallest_);
    }
    else if (smallest_ >= 1 && rate > factor_ - 1)
    {
        factor_ = max(factor_, better(rate));
    }
    residual_ = residual;
    sweeps_ = mag(factor_ - old) > 0.01 ? -2 : 0;
}


void Foam::fsi::overRelaxation::checkConverges
(
    const scalar residual,
    const label nSweeps,
    const scalar limit
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


void Foam::fsi::overRelaxation::checkEnd(const solverPerformance& result)
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


// ************************************************************************* //
