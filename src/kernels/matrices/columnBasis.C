// SPDX-License-Identifier: GPL-3.0-or-later

#include "columnBasis.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::MatrixXd Foam::fsi::columnBasis::orthonormal
(
    const Eigen::MatrixXd& columns,
    Eigen::MatrixXd& amounts
)
{
    const label n(columns.cols());
    const double least = 1e-12*columns.colwise().norm().maxCoeff();
    Eigen::MatrixXd basis(columns.rows(), n);
    amounts.setZero(n, n);
    label nBasis = 0;
    for (label k = 0; k < n; ++k)
    {
        auto next = basis.col(nBasis);
        next = columns.col(k);

        // Twice, or rounding errors of the first time stay
        for (label time = 0; time < 2; ++time)
        {
            for (label b = 0; b < nBasis; ++b)
            {
                const double amount = basis.col(b).dot(next);
                amounts(b, k) += amount;
                next -= amount*basis.col(b);
            }
        }
        const double left = next.norm();
        if (left > least)
        {
            next /= left;
            amounts(nBasis++, k) = left;
        }
    }
    amounts.conservativeResize(nBasis, n);
    return basis.leftCols(nBasis);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::columnBasis::columnBasis
(
    const std::vector<Eigen::MatrixXd>& modes,
    const label nDims
)
:
    nDims_(nDims),
    start_(1, 0)
{
    const label nModes(modes.size());
    const label nRows(nModes ? modes[0].rows() : 0);
    const label nCopies(nModes ? modes[0].cols()/nDims : 0);
    std::vector<Eigen::MatrixXd> bases(nCopies);
    amounts_.resize(nCopies);
    Eigen::MatrixXd columns(nRows, nDims*nModes);
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        for (label mode = 0; mode < nModes; ++mode)
        {
            columns.middleCols(nDims*mode, nDims) =
                modes[mode].middleCols(nDims*copyi, nDims);
        }
        bases[copyi] = orthonormal(columns, amounts_[copyi]);
        start_.append(start_.last() + label(bases[copyi].cols()));
    }
    values_.resize(nRows, start_.last());
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        values_.middleCols(start_[copyi], bases[copyi].cols()) = bases[copyi];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::columnBasis::combine(std::vector<Eigen::MatrixXd>& modes) const
{
    const label nCopies(amounts_.size());
    const label nModes(modes.size());
    for (Eigen::MatrixXd& mode : modes)
    {
        mode.resize(values_.rows(), nDims_*nCopies);
    }
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        const auto basis = values_.middleCols
        (
            start_[copyi],
            start_[copyi + 1] - start_[copyi]
        );
        for (label mode = 0; mode < nModes; ++mode)
        {
            modes[mode].middleCols(nDims_*copyi, nDims_).noalias() =
                basis*amounts_[copyi].middleCols(nDims_*mode, nDims_);
        }
    }
}


// ************************************************************************* //
