// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockPattern.H"
#include "error.H"

#include <Eigen/OrderingMethods>
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::blockPattern::order
(
    const Eigen::SparseMatrix<double>& neighbours
)
{
    Eigen::PermutationMatrix<Eigen::Dynamic> nodeAt;
    Eigen::AMDOrdering<int>()(neighbours, nodeAt);
    placeOf_.resize(neighbours.cols());
    forAll(placeOf_, place)
    {
        placeOf_[nodeAt.indices()[place]] = place;
    }
}


void Foam::fsi::blockPattern::eliminate
(
    const Eigen::SparseMatrix<double>& neighbours
)
{
    typedef Eigen::SparseMatrix<double> matrix;
    const label n = size();

    std::vector<std::vector<label>> columns(n);
    for (label node = 0; node < n; ++node)
    {
        for (matrix::InnerIterator it(neighbours, node); it; ++it)
        {
            if (placeOf_[it.row()] > placeOf_[node])
            {
                columns[placeOf_[node]].push_back(placeOf_[it.row()]);
            }
        }
    }

    start_.resize(n + 1);
    for (label k = 0; k < n; ++k)
    {
        std::vector<label>& column = columns[k];
        std::sort(column.begin(), column.end());
        column.erase
        (
            std::unique(column.begin(), column.end()),
            column.end()
        );

        start_[k] = rows_.size();
        for (const label row : column)
        {
            rows_.append(row);
        }
        if (!column.empty())
        {
            std::vector<label>& parent = columns[column.front()];
            parent.insert(parent.end(), column.begin() + 1, column.end());
        }
    }
    start_[n] = rows_.size();
}


void Foam::fsi::blockPattern::setUpdates()
{
    updateStart_.resize(size());
    for (label k = 0; k < size(); ++k)
    {
        updateStart_[k] = updates_.size();
        for (label a = start_[k]; a < start_[k + 1]; ++a)
        {
            for (label b = start_[k]; b <= a; ++b)
            {
                updates_.append(find(rows_[a], rows_[b]));
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::blockPattern::blockPattern(const label n, const entries& matrix)
{
    entries pairs;
    for (const auto& entry : matrix)
    {
        if (entry.row() < n && entry.col() < n)
        {
            pairs.emplace_back(entry.row(), entry.col(), 1);
        }
    }
    Eigen::SparseMatrix<double> neighbours(n, n);
    neighbours.setFromTriplets(pairs.begin(), pairs.end());

    order(neighbours);
    eliminate(neighbours);
    setUpdates();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::blockPattern::toRows(const double* x, scalar* rows) const
{
    const label n = size();
    for (label i = 0; i < n; ++i)
    {
        rows[2*placeOf_[i]] = x[i];
        rows[2*placeOf_[i] + 1] = x[n + i];
    }
}


void Foam::fsi::blockPattern::fromRows(const scalar* rows, double* x) const
{
    const label n = size();
    for (label i = 0; i < n; ++i)
    {
        x[i] = rows[2*placeOf_[i]];
        x[n + i] = rows[2*placeOf_[i] + 1];
    }
}


Foam::label Foam::fsi::blockPattern::find
(
    const label row,
    const label column
) const
{
    if (row == column)
    {
        return column;
    }
    const label* first = rows_.cdata() + start_[column];
    const label* last = rows_.cdata() + start_[column + 1];
    const label* found = std::lower_bound(first, last, row);
    return
        found != last && *found == row
      ? size() + label(found - rows_.cdata()) : -1;
}


Foam::label Foam::fsi::blockPattern::valueOf
(
    const label row,
    const label column
) const
{
    const label n = size();
    const label i = placeOf_[row % n], j = placeOf_[column % n];
    if (i < j)
    {
        return -1;
    }
    const label block = find(i, j);
    if (block < 0)
    {
        FatalErrorInFunction
            << "Nodes " << row % n << " and " << column % n
            << " have no block" << exit(FatalError);
    }
    return 4*block + row/n + 2*(column/n);
}


// ************************************************************************* //
