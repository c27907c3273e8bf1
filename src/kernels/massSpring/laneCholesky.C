// SPDX-License-Identifier: GPL-3.0-or-later

#include "laneCholesky.H"
#include "admmLanes.H"
#include "error.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Call an action with the number of lanes as a constant
template<class Action>
static auto withLanes(const int lanes, const Action& action)
{
    switch (lanes)
    {
        case 1: return action(std::integral_constant<int, 1>());
        case 2: return action(std::integral_constant<int, 2>());
        case 4: return action(std::integral_constant<int, 4>());
        default: return action(std::integral_constant<int, 8>());
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::laneCholesky::find
(
    const label row,
    const label column
) const
{
    const label* begin = pattern_->columnRow().begin();
    const label* first = begin + pattern_->columnStart()[column];
    const label* last = begin + pattern_->columnStart()[column + 1];
    const label* found = std::lower_bound(first, last, row);
    if (found == last || *found != row)
    {
        FatalErrorInFunction
            << "Nodes " << pattern_->order()[row] << " and "
            << pattern_->order()[column] << " are not in the pattern"
            << exit(FatalError);
    }
    return label(found - begin);
}


void Foam::fsi::laneCholesky::setPattern(const admmFactor& pattern)
{
    pattern_ = &pattern;
    const labelList& start = pattern.columnStart();
    const labelList& rows = pattern.columnRow();
    const labelList& rowOf = pattern.rowOf();
    const label n = pattern.size();

    matrixEntries_.setSize(rows.size());
    matrixEntries_ = 0;
    matrixDiagonal_.setSize(n);
    const Eigen::SparseMatrix<double>& A = pattern.matrix();
    for (label outer = 0; outer < n; ++outer)
    {
        for (Eigen::SparseMatrix<double>::InnerIterator it(A, outer); it; ++it)
        {
            const label row = rowOf[it.row()];
            const label column = rowOf[it.col()];
            if (row == column)
            {
                matrixDiagonal_[row] = it.value();
            }
            else if (row > column)
            {
                matrixEntries_[find(row, column)] = it.value();
            }
        }
    }

    // Entries by rows in the order in which store() of admmFactor made them
    columnEntry_.setSize(rows.size());
    labelList next(SubList<label>(pattern.rowStart(), n));
    for (label column = 0; column < n; ++column)
    {
        for (label e = start[column]; e < start[column + 1]; ++e)
        {
            columnEntry_[next[rows[e]]++] = e;
        }
    }
}


template<int lanes>
void Foam::fsi::laneCholesky::resetLanes(const scalar scale)
{
    forAll(matrixEntries_, e)
    {
        at<lanes>(entries_, e) = scale*matrixEntries_[e];
    }
    forAll(matrixDiagonal_, i)
    {
        at<lanes>(diagonal_, i) = scale*matrixDiagonal_[i];
    }
}


template<int lanes>
bool Foam::fsi::laneCholesky::factorLanes()
{
    typedef laneArray<lanes> values;
    const labelList& start = pattern_->columnStart();
    const labelList& rows = pattern_->columnRow();
    const labelList& rowStart = pattern_->rowStart();
    const labelList& rowColumn = pattern_->rowColumn();

    for (label j = 0; j < pattern_->size(); ++j)
    {
        for (label e = start[j]; e < start[j + 1]; ++e)
        {
            at<lanes>(column_, rows[e]) = at<lanes>(entries_, e);
        }
        values diagonal = at<lanes>(diagonal_, j);

        for (label place = rowStart[j]; place < rowStart[j + 1]; ++place)
        {
            const label entry = columnEntry_[place];
            const values ljk = at<lanes>(entries_, entry);
            diagonal -= ljk*ljk;
            const label end = start[rowColumn[place] + 1];
            for (label e = entry + 1; e < end; ++e)
            {
                at<lanes>(column_, rows[e]) -= ljk*at<lanes>(entries_, e);
            }
        }
        if (!(diagonal > 0).all())
        {
            return false;
        }
        const values inverse = diagonal.rsqrt();
        at<lanes>(diagonal_, j) = inverse;
        for (label e = start[j]; e < start[j + 1]; ++e)
        {
            at<lanes>(entries_, e) = inverse*at<lanes>(column_, rows[e]);
        }
    }
    return true;
}


template<int lanes>
void Foam::fsi::laneCholesky::solveLanes
(
    scalar* rows,
    const label nComponents
) const
{
    typedef laneArray<lanes> values;
    const labelList& start = pattern_->columnStart();
    const labelList& row = pattern_->columnRow();
    const label n = pattern_->size();
    const auto value = [&](const label i, const label cmpt)
    {
        return Eigen::Map<values>(rows + lanes*(nComponents*i + cmpt));
    };

    for (label cmpt = 0; cmpt < nComponents; ++cmpt)
    {
        for (label j = 0; j < n; ++j)
        {
            const values x = at<lanes>(diagonal_, j)*value(j, cmpt);
            value(j, cmpt) = x;
            for (label e = start[j]; e < start[j + 1]; ++e)
            {
                value(row[e], cmpt) -= at<lanes>(entries_, e)*x;
            }
        }
        for (label j = n - 1; j >= 0; --j)
        {
            values x = value(j, cmpt);
            for (label e = start[j]; e < start[j + 1]; ++e)
            {
                x -= at<lanes>(entries_, e)*value(row[e], cmpt);
            }
            value(j, cmpt) = at<lanes>(diagonal_, j)*x;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::laneCholesky::reset
(
    const admmFactor& pattern,
    const scalar scale,
    const int lanes
)
{
    if (pattern_ != &pattern)
    {
        setPattern(pattern);
    }
    lanes_ = lanes;
    entries_.setSize(lanes*matrixEntries_.size());
    diagonal_.setSize(lanes*matrixDiagonal_.size());
    column_.setSize(lanes*matrixDiagonal_.size());
    withLanes(lanes, [&](auto n) { resetLanes<decltype(n)::value>(scale); });
}


void Foam::fsi::laneCholesky::add
(
    const int lane,
    const label nodeA,
    const label nodeB,
    const scalar value
)
{
    const label a = pattern_->rowOf()[nodeA];
    const label b = pattern_->rowOf()[nodeB];
    if (a == b)
    {
        diagonal_[lanes_*a + lane] += value;
    }
    else
    {
        entries_[lanes_*find(max(a, b), min(a, b)) + lane] += value;
    }
}


bool Foam::fsi::laneCholesky::factor()
{
    return withLanes
    (
        lanes_,
        [&](auto n) { return factorLanes<decltype(n)::value>(); }
    );
}


void Foam::fsi::laneCholesky::solve
(
    scalar* rows,
    const label nComponents
) const
{
    withLanes
    (
        lanes_,
        [&](auto n) { solveLanes<decltype(n)::value>(rows, nComponents); }
    );
}


// ************************************************************************* //
