// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "admmLanes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int lanes>
void Foam::fsi::admmSolver::load(const state& s, const label copyi)
{
    const labelList& rowOf = factor_->rowOf();
    const label n = shape_.nNodes();

    for (int lane = 0; lane < lanes; ++lane)
    {
        for (int i = 0; i < 2; ++i)
        {
            const label column = 2*(copyi + lane) + i;
            const double* x = s.positions.col(column).data();
            const double* v = s.velocities.col(column).data();
            const double* f = s.forces.col(column).data();
            for (label nodei = 0; nodei < n; ++nodei)
            {
                const label row = rowOf[nodei];
                const label place = lanes*(2*row + i) + lane;
                start_[place] = x[nodei];
                displacement_[place] = x[nodei] - shape_.points()[nodei][i];
                change_[place] = deltaT_*v[nodei];
                inertial_[place] =
                    change_[place] + sqr(deltaT_)*f[nodei]/masses_[row];
            }
        }
    }
}


template<int lanes>
void Foam::fsi::admmSolver::setRestLengths
(
    const state& s,
    const label copyi
)
{
    const springLaw& law = shape_.law();
    laneArray<lanes> state = laneArray<lanes>::Zero();

    forAll(springWeights_, springi)
    {
        const label a = springRows_[2*springi];
        const label b = springRows_[2*springi + 1];
        const laneArray<lanes> x =
            at<lanes>(start_, 2*b) - at<lanes>(start_, 2*a);
        const laneArray<lanes> y =
            at<lanes>(start_, 2*b + 1) - at<lanes>(start_, 2*a + 1);
        const laneArray<lanes> length = (x*x + y*y).sqrt();

        if (law.hasState())
        {
            for (int lane = 0; lane < lanes; ++lane)
            {
                state[lane] = s.springStates(springi, copyi + lane);
            }
        }
        law.restLengths
        (
            lanes,
            shape_.restLengths()[springi],
            length.data(),
            state.data(),
            deltaT_,
            restLengths_.data() + lanes*springi
        );
    }
}


template<int lanes>
void Foam::fsi::admmSolver::inertialResidual()
{
    forAll(masses_, row)
    {
        for (label place = 2*row; place < 2*row + 2; ++place)
        {
            to<lanes>(residual_, place) = masses_[row]
               *(at<lanes>(inertial_, place) - at<lanes>(change_, place));
        }
    }
}


template<int lanes>
void Foam::fsi::admmSolver::startWithMomentum()
{
    laneArray<lanes> missing[2];
    for (int i = 0; i < 2; ++i)
    {
        missing[i] = laneArray<lanes>::Zero();
        forAll(masses_, row)
        {
            missing[i] += masses_[row]
               *(
                    at<lanes>(inertial_, 2*row + i)
                  - at<lanes>(change_, 2*row + i)
                );
        }
        missing[i] /= sum(masses_);
    }
    for (label place = 0; place < 2*masses_.size(); ++place)
    {
        to<lanes>(change_, place) += missing[place % 2];
    }
}


template<int lanes>
Foam::scalar Foam::fsi::admmSolver::globalStep()
{
    const label n = 2*lanes*shape_.nNodes();
    Eigen::Map<Eigen::ArrayXd> change(change_.data(), n);
    Eigen::Map<const Eigen::ArrayXd> residual(residual_.cdata(), n);

    if (shape_.admm().quasiNewton)
    {
        acceleration_.keepResidual(residual_);
        factor_->solveRows(2*lanes, residual_.data());
        acceleration_.step<lanes>
        (
            (8*shape_.admm().areaWeight/at<lanes>(stretch_, 0)).min(1),
            residual_,
            change_
        );
    }
    else
    {
        factor_->solveRows(2*lanes, residual_.data());
        change += residual;
    }
    return residual.abs().maxCoeff()/shape_.nodeSpacing();
}


template<int lanes>
void Foam::fsi::admmSolver::store
(
    const label copyi,
    Eigen::MatrixXd& v
) const
{
    const labelList& rowOf = factor_->rowOf();
    const label n = shape_.nNodes();

    for (int lane = 0; lane < lanes; ++lane)
    {
        for (int i = 0; i < 2; ++i)
        {
            double* column = v.col(2*(copyi + lane) + i).data();
            for (label nodei = 0; nodei < n; ++nodei)
            {
                column[nodei] =
                    change_[lanes*(2*rowOf[nodei] + i) + lane]/deltaT_;
            }
        }
    }
}


template<int lanes>
void Foam::fsi::admmSolver::solveBlock
(
    const state& s,
    const label copyi,
    Eigen::MatrixXd& v
)
{
    load<lanes>(s, copyi);
    if (!viscousWeights_.empty())
    {
        forAll(lessDrift_, place)
        {
            lessDrift_[place] = -change_[place];
        }
    }
    setRestLengths<lanes>(s, copyi);

    if (shape_.admm().quasiNewton)
    {
        startWithMomentum<lanes>();
        acceleration_.start(2*lanes*shape_.nNodes());
    }
    label iteration = 0;
    scalar change = GREAT;
    while
    (
        iteration < shape_.admm().iterations
     && change > shape_.admm().tolerance
    )
    {
        inertialResidual<lanes>();
        localStep
        (
            lanes,
            shape_.admm().quasiNewton ? admmStep::force
          : iteration == 0 ? admmStep::start
          : admmStep::local
        );
        change = globalStep<lanes>();
        ++iteration;
    }
    nIterations_ = max(nIterations_, iteration);
    lastChange_ = max(lastChange_, change);

    restoreAngularMomentum<lanes>();
    store<lanes>(copyi, v);
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    template void admmSolver::solveBlock<1>
    (const state&, const label, Eigen::MatrixXd&);
    template void admmSolver::solveBlock<2>
    (const state&, const label, Eigen::MatrixXd&);
    template void admmSolver::solveBlock<4>
    (const state&, const label, Eigen::MatrixXd&);
    template void admmSolver::solveBlock<8>
    (const state&, const label, Eigen::MatrixXd&);
}
}


// ************************************************************************* //
