// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmFactor.H"
#include "laneField.H"
#include "laneReference.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int width>
[[gnu::always_inline]]
inline void Foam::fsi::admmFactor::solveWidth(scalar* rows) const
{
    // The sum of a row stays in registers, as the width is known
    typedef laneArray<width> values;
    const label n = size();

    for (label i = 0; i < n; ++i)
    {
        values sum = at<width>(rows, i);
        for (label e = rowStart_[i]; e < rowStart_[i + 1]; ++e)
        {
            sum -= rowValue_[e]*at<width>(rows, rowColumn_[e]);
        }
        to<width>(rows, i) = inverseDiagonal_[i]*sum;
    }

    for (label i = n - 1; i >= 0; --i)
    {
        values sum = at<width>(rows, i);
        for (label e = columnStart_[i]; e < columnStart_[i + 1]; ++e)
        {
            sum -= columnValue_[e]*at<width>(rows, columnRow_[e]);
        }
        to<width>(rows, i) = inverseDiagonal_[i]*sum;
    }
}


template<int width>
[[gnu::always_inline]]
inline void Foam::fsi::admmFactor::multiplyWidth
(
    const scalar* from,
    scalar* result
) const
{
    const int* start = matrix_.outerIndexPtr();
    const int* column = matrix_.innerIndexPtr();
    const double* value = matrix_.valuePtr();
    for (label i = 0; i < size(); ++i)
    {
        laneArray<width> sum(0);
        for (int e = start[i]; e < start[i + 1]; ++e)
        {
            sum += value[e]*at<width>(from, column[e]);
        }
        to<width>(result, i) = sum;
    }
}


FSI_AVX2_CLONES
void Foam::fsi::admmFactor::multiplyRows
(
    const int width,
    const scalar* from,
    scalar* result
) const
{
    switch (width)
    {
        case 16: multiplyWidth<16>(from, result); break;
        case 8: multiplyWidth<8>(from, result); break;
        case 4: multiplyWidth<4>(from, result); break;
        default: multiplyWidth<2>(from, result);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

FSI_AVX2_CLONES
void Foam::fsi::admmFactor::solveRows(const int width, scalar* rows) const
{
    switch (width)
    {
        case 16: solveWidth<16>(rows); break;
        case 8: solveWidth<8>(rows); break;
        case 4: solveWidth<4>(rows); break;
        default: solveWidth<2>(rows);
    }
}


Eigen::MatrixXd Foam::fsi::admmFactor::multiply
(
    const Eigen::MatrixXd& x
) const
{
    Eigen::MatrixXd result(x.rows(), x.cols());
    laneField from, to;
    label width = 2;
    while (width < min(label(x.cols()), largestWidth))
    {
        width *= 2;
    }
    from.resize(width*size());
    to.resize(width*size());
    for (label first = 0; first < x.cols(); first += width)
    {
        const label nColumns = min(width, label(x.cols()) - first);
        for (label k = 0; k < nColumns; ++k)
        {
            const double* column = x.col(first + k).data();
            for (label i = 0; i < size(); ++i)
            {
                from[width*i + k] = column[i];
            }
        }
        multiplyRows(width, from.data(), to.data());
        for (label k = 0; k < nColumns; ++k)
        {
            double* column = result.col(first + k).data();
            for (label i = 0; i < size(); ++i)
            {
                column[i] = to[width*i + k];
            }
        }
    }
    return result;
}


// ************************************************************************* //
