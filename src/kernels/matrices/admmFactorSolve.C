// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmFactor.H"
#include "lanePanel.H"
#include "laneReference.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Least power of two, 2 at least, for a number of columns, or the largest one
static label widthFor(const label nColumns, const label largest)
{
    label width = 2;
    while (width < min(nColumns, largest))
    {
        width *= 2;
    }
    return width;
}


//- A symmetric matrix times `width` columns side by side
template<int width>
FSI_INLINE void multiplyWidth
(
    const Eigen::SparseMatrix<double>& matrix,
    const scalar* from,
    scalar* result
)
{
    const int* start = matrix.outerIndexPtr();
    const int* column = matrix.innerIndexPtr();
    const double* value = matrix.valuePtr();
    for (label i = 0; i < matrix.outerSize(); ++i)
    {
        laneArray<width> sum(0);
        for (int e = start[i]; e < start[i + 1]; ++e)
        {
            sum += value[e]*at<width>(from, column[e]);
        }
        to<width>(result, i) = sum;
    }
}


//- Multiply rows of 2, 4, 8, 16 or 32 columns
FSI_AVX2_CLONES
void multiplyRows
(
    const int width,
    const Eigen::SparseMatrix<double>& matrix,
    const scalar* from,
    scalar* result
)
{
    switch (width)
    {
        case 32: multiplyWidth<32>(matrix, from, result); break;
        case 16: multiplyWidth<16>(matrix, from, result); break;
        case 8: multiplyWidth<8>(matrix, from, result); break;
        case 4: multiplyWidth<4>(matrix, from, result); break;
        default: multiplyWidth<2>(matrix, from, result);
    }
}


//- Multiply any number of columns of a matrix
static void multiplyColumns
(
    const Eigen::SparseMatrix<double>& matrix,
    const Eigen::MatrixXd& x,
    Eigen::MatrixXd& result
)
{
    const label n = matrix.outerSize();
    const label width = widthFor(x.cols(), 32);
    laneField from, to;
    from.resize(width*n);
    to.resize(width*n);
    result.resize(n, x.cols());
    const auto same = [](const label i) { return i; };
    for (label first = 0; first < x.cols(); first += width)
    {
        const label nColumns = min(width, label(x.cols()) - first);
        const lanePanel panel{first, nColumns, width, same, same};
        columnsToRows(x, panel, from);
        multiplyRows(width, matrix, from.data(), to.data());
        rowsToColumns(to, panel, result);
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::admmFactor::solve(Eigen::MatrixXd& b) const
{
    const label width = widthFor(b.cols(), 16);
    laneField rows;
    rows.resize(width*size());
    const auto row = [&](const label i) { return rowOf_[i]; };
    const auto same = [](const label k) { return k; };
    for (label first = 0; first < b.cols(); first += width)
    {
        const label nColumns = min(width, label(b.cols()) - first);
        const lanePanel panel{first, nColumns, width, row, same};
        columnsToRows(b, panel, rows);
        solveRows(width, rows.data());
        rowsToColumns(rows, panel, b);
    }
}


Eigen::MatrixXd Foam::fsi::admmFactor::multiply
(
    const Eigen::MatrixXd& x
) const
{
    Eigen::MatrixXd result;
    multiplyColumns(matrix_, x, result);
    return result;
}


void Foam::fsi::admmFactor::solveBoundary
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    boundaryInverse();
    multiplyColumns(sparseInverse_, f, v);
}


void Foam::fsi::admmFactor::solveFullBoundary
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    if (denseInverse_.size() == 0)
    {
        denseInverse_ = densePanels(boundaryInverse());
    }
    denseInverse_.multiply(f, v);
}


Foam::scalar Foam::fsi::admmFactor::boundaryFill() const
{
    boundaryInverse();
    return scalar(sparseInverse_.nonZeros())/sqr(scalar(nBoundary_));
}


// ************************************************************************* //
