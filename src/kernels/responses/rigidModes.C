// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidModes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Node masses as a vector
Eigen::Map<const Eigen::VectorXd> vectorOf(const scalarField& masses)
{
    return {masses.cdata(), masses.size()};
}


//- Velocities of a copy that turns about an axis through its centre of mass
//  with 1 rad/s; arms: nodes less the centre of mass
void turn
(
    const Eigen::MatrixXd& arms,
    const direction axis,
    Eigen::Ref<Eigen::MatrixXd> velocities
)
{
    // Two dimensions: axis 2, z
    const direction first = (axis + 1) % 3, second = (axis + 2) % 3;
    velocities.setZero();
    velocities.col(first) = -arms.col(second);
    velocities.col(second) = arms.col(first);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::rigidModes::product
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b,
    const direction nDims,
    const label copyi
)
{
    scalar sum = 0;
    for (label column = nDims*copyi; column < nDims*(copyi + 1); ++column)
    {
        sum += a.col(column).dot(b.col(column));
    }
    return sum;
}


void Foam::fsi::rigidModes::orthonormalise
(
    modeList& modes,
    const smallMatrix& products,
    const direction nDims,
    const label copyi
)
{
    const label n(modes.size());
    const smallMatrix L(products.llt().matrixL());
    for (label k = 0; k < n; ++k)
    {
        auto mode = modes[k].middleCols(nDims*copyi, nDims);
        for (label l = 0; l < k; ++l)
        {
            mode -= L(k, l)*modes[l].middleCols(nDims*copyi, nDims);
        }
        mode /= L(k, k);
    }
}


Foam::fsi::rigidModes::modeList Foam::fsi::rigidModes::rotations
(
    const scalarField& masses,
    const Eigen::MatrixXd& positions,
    const direction nDims,
    const UList<direction>& axes
)
{
    const auto m = vectorOf(masses);
    const scalar mass = m.sum();
    const label n = axes.size();

    modeList modes(n, Eigen::MatrixXd(positions.rows(), positions.cols()));
    smallMatrix inertia(n, n);
    Eigen::MatrixXd arms;
    for (label copyi = 0; copyi < positions.cols()/nDims; ++copyi)
    {
        arms = positions.middleCols(nDims*copyi, nDims);
        // Twice: far from the origin the first mean is rounded
        for (label i = 0; i < 2*nDims; ++i)
        {
            auto arm = arms.col(i % nDims);
            arm.array() -= m.dot(arm)/mass;
        }
        const auto mode = [&](const label k)
        {
            return modes[k].middleCols(nDims*copyi, nDims);
        };
        for (label k = 0; k < n; ++k)
        {
            turn(arms, axes[k], mode(k));
            for (label l = 0; l <= k; ++l)
            {
                inertia(k, l) = inertia(l, k) =
                    m.dot(mode(k).cwiseProduct(mode(l)).rowwise().sum());
            }
        }
        orthonormalise(modes, inertia, nDims, copyi);
    }
    return modes;
}


Foam::fsi::rigidModes::modeList Foam::fsi::rigidModes::translations
(
    const scalarField& masses,
    const label nCopies,
    const direction nDims,
    const UList<direction>& axes
)
{
    const scalar speed = 1/std::sqrt(vectorOf(masses).sum());
    modeList modes
    (
        axes.size(), Eigen::MatrixXd::Zero(masses.size(), nDims*nCopies)
    );
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        forAll(axes, k)
        {
            modes[k].col(nDims*copyi + axes[k]).setConstant(speed);
        }
    }
    return modes;
}


// ************************************************************************* //
