// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "angularMomentum.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::admmSolver::setTimeStep(const scalar dt)
{
    // Asked for each time, as the shape keeps only the last few factors
    factor_ = &shape_.factor(dt);
    if (dt != block_.deltaT)
    {
        block_.setFactor(*factor_);
        springs_.setFactor(*factor_);
        elements_.setFactor(*factor_);
    }
}


template<int lanes>
Foam::scalar Foam::fsi::admmSolver::globalStep()
{
    const label n = block_.size(lanes);
    Eigen::Map<const Eigen::ArrayXd> residual(block_.residual.cdata(), n);

    if (shape_.admm().quasiNewton)
    {
        acceleration_.keepResidual(block_.residual);
        factor_->solveRows(block_.nDims*lanes, block_.residual.data());
        acceleration_.step<lanes>
        (
            elements_.part<lanes>(),
            block_.residual,
            block_.change
        );
    }
    else
    {
        factor_->solveRows(block_.nDims*lanes, block_.residual.data());
        Eigen::Map<Eigen::ArrayXd>(block_.change.data(), n) += residual;
    }
    return residual.abs().maxCoeff()/shape_.nodeSpacing();
}


template<int lanes>
void Foam::fsi::admmSolver::solveBlock
(
    const copyState& s,
    const label copyi,
    Eigen::MatrixXd& v
)
{
    const admmControls& controls = shape_.admm();
    block_.resize(lanes);
    springs_.resize(lanes);
    elements_.resize(lanes);
    block_.load<lanes>(s, copyi);
    springs_.start(lanes, block_, s.springStates, copyi);
    if (controls.quasiNewton)
    {
        block_.restoreMomentum<lanes>();
        acceleration_.start(block_.size(lanes));
    }

    label iteration = 0;
    scalar change = GREAT;
    while (iteration < controls.iterations && change > controls.tolerance)
    {
        const dualStep step =
            controls.quasiNewton ? dualStep::force
          : iteration == 0 ? dualStep::start
          : dualStep::local;
        block_.inertialResidual<lanes>();
        springs_.add(lanes, step, block_);
        elements_.add(lanes, step, block_);
        change = globalStep<lanes>();
        ++iteration;
    }
    nIterations_ = max(nIterations_, iteration);
    lastChange_ = max(lastChange_, change);

    angularMomentum::restore<lanes>
    (
        block_, controls.conserving && !s.armsAtEnd
    );
    block_.store<lanes>(copyi, v);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::admmSolver::admmSolver(const shapeTemplate& shape)
:
    shape_(shape),
    block_(shape),
    springs_(shape),
    elements_(shape)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::admmSolver::solve
(
    const scalar dt,
    const state& s,
    const labelRange& copies,
    Eigen::MatrixXd& v
)
{
    setTimeStep(dt);
    v.resize(s.positions.rows(), s.positions.cols());
    nIterations_ = 0;
    lastChange_ = 0;

    for (label copyi = firstOf(copies); copyi <= lastOf(copies);)
    {
        const label left = lastOf(copies) + 1 - copyi;
        const label lanes = left >= 8 ? 8 : left >= 4 ? 4 : left >= 2 ? 2 : 1;
        switch (lanes)
        {
            case 8: solveBlock<8>(s, copyi, v); break;
            case 4: solveBlock<4>(s, copyi, v); break;
            case 2: solveBlock<2>(s, copyi, v); break;
            default: solveBlock<1>(s, copyi, v);
        }
        copyi += lanes;
    }
}


void Foam::fsi::admmSolver::solve
(
    const scalar dt,
    const state& s,
    Eigen::MatrixXd& v
)
{
    solve(dt, s, labelRange(0, s.positions.cols()/shape_.nDims()), v);
}


// ************************************************************************* //
