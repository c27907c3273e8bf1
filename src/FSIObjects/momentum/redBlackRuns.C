// SPDX-License-Identifier: GPL-3.0-or-later

#include "redBlackRuns.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Relax rows first to last - 1, whose neighbours are at offsets; sum of the
//  squared residuals before
template<int nCmpts>
FSI_INLINE scalar relaxRun
(
    const relaxedRows& rows,
    const label first,
    const label last,
    const label* offset
)
{
    constexpr int nSlots = 2*nCmpts;
    const floatScalar* __restrict__ coefficient = rows.coefficient;
    const floatScalar* __restrict__ diagonal = rows.diagonal;
    const floatScalar* __restrict__ source = rows.source;
    const floatScalar relaxation = rows.relaxation;

    // Values of a run are written, those of its neighbours read
    floatScalar* __restrict__ x = rows.x;
    const floatScalar* __restrict__ other[nSlots];
    for (int k = 0; k < nSlots; ++k)
    {
        other[k] = rows.x + nCmpts*offset[k];
    }

    floatScalar squares[nCmpts] = {};
    for (label row = first; row < last; ++row)
    {
        for (int d = 0; d < nCmpts; ++d)
        {
            const label i = nCmpts*row + d;
            floatScalar residual = source[i] - diagonal[i]*x[i];
            for (int k = 0; k < nSlots; ++k)
            {
                residual -= coefficient[nSlots*row + k]*other[k][i];
            }
            x[i] += relaxation*residual/diagonal[i];
            squares[d] += residual*residual;
        }
    }
    scalar sum = 0;
    for (int d = 0; d < nCmpts; ++d)
    {
        sum += squares[d];
    }
    return sum;
}


//- Two rows of two components
typedef floatScalar rowPair __attribute__
((vector_size(4*sizeof(floatScalar)), aligned(sizeof(floatScalar))));


FSI_INLINE rowPair& pairAt(floatScalar* place)
{
    return *reinterpret_cast<rowPair*>(place);
}


FSI_INLINE const rowPair& pairAt(const floatScalar* place)
{
    return *reinterpret_cast<const rowPair*>(place);
}


//- relaxRun<2>, two rows at once: left to itself the compiler takes them apart
FSI_INLINE scalar relaxPairs
(
    const relaxedRows& rows,
    const label first,
    const label last,
    const label* offset
)
{
    const floatScalar* other[4];
    for (int k = 0; k < 4; ++k)
    {
        other[k] = rows.x + 2*offset[k];
    }

    rowPair squares = {};
    label row = first;
    for (; row + 1 < last; row += 2)
    {
        const label i = 2*row;
        const rowPair a = pairAt(rows.coefficient + 4*row);
        const rowPair b = pairAt(rows.coefficient + 4*row + 4);
        const rowPair diagonal = pairAt(rows.diagonal + i);
        rowPair residual =
            pairAt(rows.source + i) - diagonal*pairAt(rows.x + i);

        // Each row's coefficient for both of its components
        for (int k = 0; k < 4; ++k)
        {
            residual -=
                rowPair{a[k], a[k], b[k], b[k]}*pairAt(other[k] + i);
        }
        pairAt(rows.x + i) += rows.relaxation*residual/diagonal;
        squares += residual*residual;
    }
    scalar sum = scalar(squares[0]) + squares[1] + squares[2] + squares[3];
    return sum + relaxRun<2>(rows, row, last, offset);
}


FSI_AVX2_CLONES
scalar relaxRun
(
    const label nCmpts,
    const relaxedRows& rows,
    const label first,
    const label last,
    const label* offset
)
{
    return
        nCmpts == 2
      ? relaxPairs(rows, first, last, offset)
      : relaxRun<3>(rows, first, last, offset);
}


//- Set the correction's equation in rows first to last - 1
template<int nCmpts>
FSI_INLINE void residualRun
(
    const residualRows& rows,
    const label first,
    const label last,
    const label* offset
)
{
    constexpr int nSlots = 2*nCmpts;
    const scalar* __restrict__ coefficient = rows.coefficient;
    const scalar* __restrict__ diagonal = rows.diagonal;
    const scalar* __restrict__ source = rows.source;
    const scalar* __restrict__ x = rows.x;
    floatScalar* __restrict__ singleCoefficient = rows.singleCoefficient;
    floatScalar* __restrict__ singleDiagonal = rows.singleDiagonal;
    floatScalar* __restrict__ result = rows.residual;
    const scalar scale = rows.scale;

    for (label row = first; row < last; ++row)
    {
        for (int d = 0; d < nCmpts; ++d)
        {
            const label i = nCmpts*row + d;
            scalar residual = source[i] - diagonal[i]*x[i];
            for (int k = 0; k < nSlots; ++k)
            {
                residual -=
                    coefficient[nSlots*row + k]*x[i + nCmpts*offset[k]];
            }
            result[i] = floatScalar(scale*residual);
            singleDiagonal[i] = floatScalar(diagonal[i]);
        }
        for (int k = 0; k < nSlots; ++k)
        {
            singleCoefficient[nSlots*row + k] =
                floatScalar(coefficient[nSlots*row + k]);
        }
    }
}


FSI_AVX2_CLONES
void residualRun
(
    const label nCmpts,
    const residualRows& rows,
    const label first,
    const label last,
    const label* offset
)
{
    if (nCmpts == 2)
    {
        residualRun<2>(rows, first, last, offset);
    }
    else
    {
        residualRun<3>(rows, first, last, offset);
    }
}

} // End namespace fsi
} // End namespace Foam


// ************************************************************************* //
