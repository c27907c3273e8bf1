// SPDX-License-Identifier: GPL-3.0-or-later

#include "laneResponse.H"
#include "lanePanel.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::laneResponse::laneResponse(const bodyGroup& group)
:
    woodburyResponse(group)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::laneResponse::factorBlock
(
    const label blocki,
    const std::vector<copyLink>* links
)
{
    laneCholesky& block = factors_[blocki];
    block.reset(boundary(), 1/deltaT_, lanes());
    const label first = blocki*lanes();
    const label last = min(first + lanes(), group_.size());
    for (label copyi = first; copyi < last; ++copyi)
    {
        for (const copyLink& link : links[copyi])
        {
            const label n = link.nNodes();
            for (label i = 0; i < n; ++i)
            {
                for (label j = 0; j <= i; ++j)
                {
                    block.add
                    (
                        int(copyi - first),
                        link.nodes[i],
                        link.nodes[j],
                        link.coefficient*link.weights[i]*link.weights[j]
                    );
                }
            }
        }
    }
    if (!block.factor())
    {
        FatalErrorInFunction
            << "The matrix of the viscous links of a copy of shape "
            << group_.shape().name() << ", " << first << " to " << last - 1
            << ", is not positive definite" << exit(FatalError);
    }
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::laneResponse::makeMatrices
(
    const std::vector<copyLink>* links,
    std::vector<Eigen::MatrixXd>& x
)
{
    factors_.resize
    (
        (group_.size() + lanes() - 1)/lanes()
    );
    for (label blocki = 0; blocki < label(factors_.size()); ++blocki)
    {
        factorBlock(blocki, links);
    }
    solveMatrices(x);
}


void Foam::fsi::laneResponse::solveMatrices
(
    const Eigen::MatrixXd& b,
    Eigen::MatrixXd& x
) const
{
    const label lanes = this->lanes();
    const label nDims = group_.shape().nDims();
    const labelList& rowOf = boundary().rowOf();
    const label n = b.rows();

    x.resize(n, b.cols());
    const label nValues = lanes*nDims*n;
    rows_.resize(nValues);
    const auto row = [&](const label i) { return rowOf[i]; };
    const auto place = [&](const label k)
    {
        return lanes*(k % nDims) + k/nDims;
    };
    for (label blocki = 0; blocki < label(factors_.size()); ++blocki)
    {
        const label first = nDims*lanes*blocki;
        const label nColumns = min(nDims*lanes, label(b.cols()) - first);
        if (nColumns < nDims*lanes)
        {
            std::fill_n(rows_.data(), nValues, 0);
        }
        const lanePanel panel{first, nColumns, nDims*lanes, row, place};
        columnsToRows(b, panel, rows_);
        factors_[blocki].solve(rows_.data(), nDims);
        rowsToColumns(rows_, panel, x);
    }
}


// ************************************************************************* //
