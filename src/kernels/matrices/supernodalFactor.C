// SPDX-License-Identifier: GPL-3.0-or-later

#include "supernodalFactor.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::supernodalFactor::findSupernodes
(
    const Eigen::SparseMatrix<double>& lower
)
{
    const int* start = lower.outerIndexPtr();
    const int* row = lower.innerIndexPtr();
    const label n = lower.cols();
    DynamicList<label> first;
    label nEntries = 0;
    for (label j = 0; j < n; ++j)
    {
        // Together with the columns before it if it is the first row of the
        // last one, and thus has all of their rows
        const label nOwn = start[j + 1] - start[j];
        const label nBefore = first.empty() ? 0 : j - first.last();
        const label nFull = nBefore*nOwn + (nBefore + 1)*nBefore/2 + nOwn;
        const bool joins =
            nBefore > 0 && nBefore < maxColumns
         && start[j] - start[j - 1] > 1 && row[start[j - 1] + 1] == j
         && nFull - nEntries - nOwn <= maxZeros*nFull;
        if (!joins)
        {
            first.append(j);
            nEntries = 0;
        }
        nEntries += nOwn;
    }
    first.append(n);
    first_ = first;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::supernodalFactor::supernodalFactor
(
    const Eigen::SparseMatrix<double>& lower
)
{
    const int* start = lower.outerIndexPtr();
    const int* row = lower.innerIndexPtr();
    findSupernodes(lower);

    const label nBlocks = first_.size() - 1;
    start_.resize(nBlocks + 1);
    block_.resize(nBlocks + 1);
    start_[0] = 0;
    block_[0] = 0;
    for (label s = 0; s < nBlocks; ++s)
    {
        const label last = first_[s + 1] - 1;
        const label nColumns = last + 1 - first_[s];
        const label nRows = start[last + 1] - start[last] - 1;
        start_[s + 1] = start_[s] + nRows;
        block_[s + 1] = block_[s] + nColumns*(nColumns + nRows);
    }

    rows_.resize(start_[nBlocks]);
    values_.resize(block_[nBlocks]);
    values_ = 0;
    labelList place(lower.rows(), -1);
    for (label s = 0; s < nBlocks; ++s)
    {
        const label first = first_[s];
        const label nColumns = first_[s + 1] - first;
        for (label k = 0; k < nColumns; ++k)
        {
            place[first + k] = k;
        }
        const int* below = row + start[first + nColumns - 1] + 1;
        for (label r = 0; r < start_[s + 1] - start_[s]; ++r)
        {
            rows_[start_[s] + r] = below[r];
            place[below[r]] = nColumns + r;
        }
        for (label k = 0; k < nColumns; ++k)
        {
            for (int e = start[first + k]; e < start[first + k + 1]; ++e)
            {
                const scalar value = lower.valuePtr()[e];
                values_[block_[s] + nColumns*place[row[e]] + k] =
                    row[e] == first + k ? 1/value : value;
            }
        }
    }
}


// ************************************************************************* //
