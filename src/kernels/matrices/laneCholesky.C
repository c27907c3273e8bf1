// SPDX-License-Identifier: GPL-3.0-or-later

#include "laneCholesky.H"
#include "SubList.H"
#include "laneReference.H"
#include "vectorClones.H"
#include "error.H"

#include <algorithm>

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
[[gnu::always_inline]]
inline bool Foam::fsi::laneCholesky::factorLanes()
{
    typedef laneArray<lanes> values;
    const labelList& start = pattern_->columnStart();
    const labelList& rows = pattern_->columnRow();
    const labelList& rowStart = pattern_->rowStart();
    const labelList& rowColumn = pattern_->rowColumn();
    scalar* entries = entries_.data();
    scalar* column = column_.data();
    scalar* diagonals = diagonal_.data();

    for (label j = 0; j < pattern_->size(); ++j)
    {
        for (label e = start[j]; e < start[j + 1]; ++e)
        {
            to<lanes>(column, rows[e]) = at<lanes>(entries, e);
        }
        values diagonal = at<lanes>(diagonals, j);

        for (label place = rowStart[j]; place < rowStart[j + 1]; ++place)
        {
            const label entry = columnEntry_[place];
            const values ljk = at<lanes>(entries, entry);
            diagonal -= ljk*ljk;
            const label end = start[rowColumn[place] + 1];
            for (label e = entry + 1; e < end; ++e)
            {
                to<lanes>(column, rows[e]) -= ljk*at<lanes>(entries, e);
            }
        }
        if (!diagonal.positive())
        {
            return false;
        }
        const values inverse = 1/diagonal.sqrt();
        to<lanes>(diagonals, j) = inverse;
        for (label e = start[j]; e < start[j + 1]; ++e)
        {
            to<lanes>(entries, e) = inverse*at<lanes>(column, rows[e]);
        }
    }
    return true;
}


template<int lanes, int nComponents>
[[gnu::always_inline]]
inline void Foam::fsi::laneCholesky::solveLanes
(
    scalar* rows
) const
{
    typedef laneArray<lanes> values;
    const labelList& start = pattern_->columnStart();
    const labelList& row = pattern_->columnRow();
    const label n = pattern_->size();
    const scalar* entries = entries_.data();
    const scalar* diagonals = diagonal_.data();

    // All components at once: entries are read once in each direction
    values x[nComponents];
    for (label j = 0; j < n; ++j)
    {
        const values inverse = at<lanes>(diagonals, j);
        for (int d = 0; d < nComponents; ++d)
        {
            x[d] = inverse*at<lanes>(rows, nComponents*j + d);
            to<lanes>(rows, nComponents*j + d) = x[d];
        }
        for (label e = start[j]; e < start[j + 1]; ++e)
        {
            const values entry = at<lanes>(entries, e);
            for (int d = 0; d < nComponents; ++d)
            {
                to<lanes>(rows, nComponents*row[e] + d) -= entry*x[d];
            }
        }
    }
    for (label j = n - 1; j >= 0; --j)
    {
        for (int d = 0; d < nComponents; ++d)
        {
            x[d] = at<lanes>(rows, nComponents*j + d);
        }
        for (label e = start[j]; e < start[j + 1]; ++e)
        {
            const values entry = at<lanes>(entries, e);
            for (int d = 0; d < nComponents; ++d)
            {
                x[d] -= entry*at<lanes>(rows, nComponents*row[e] + d);
            }
        }
        const values inverse = at<lanes>(diagonals, j);
        for (int d = 0; d < nComponents; ++d)
        {
            to<lanes>(rows, nComponents*j + d) = inverse*x[d];
        }
    }
}


template<int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::laneCholesky::solveLanes
(
    scalar* rows,
    const label nComponents
) const
{
    if (nComponents == 2)
    {
        solveLanes<lanes, 2>(rows);
    }
    else
    {
        solveLanes<lanes, 3>(rows);
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
    entries_.resize(lanes*matrixEntries_.size());
    diagonal_.resize(lanes*matrixDiagonal_.size());
    column_.resize(lanes*matrixDiagonal_.size());
    forAll(matrixEntries_, e)
    {
        std::fill_n(&entries_[lanes*e], lanes, scale*matrixEntries_[e]);
    }
    forAll(matrixDiagonal_, i)
    {
        std::fill_n(&diagonal_[lanes*i], lanes, scale*matrixDiagonal_[i]);
    }
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


FSI_AVX2_CLONES
bool Foam::fsi::laneCholesky::factor()
{
    switch (lanes_)
    {
        case 8: return factorLanes<8>();
        case 4: return factorLanes<4>();
        case 2: return factorLanes<2>();
        default: return factorLanes<1>();
    }
}


FSI_AVX2_CLONES
void Foam::fsi::laneCholesky::solve
(
    scalar* rows,
    const label nComponents
) const
{
    switch (lanes_)
    {
        case 8: solveLanes<8>(rows, nComponents); break;
        case 4: solveLanes<4>(rows, nComponents); break;
        case 2: solveLanes<2>(rows, nComponents); break;
        default: solveLanes<1>(rows, nComponents);
    }
}


// ************************************************************************* //
