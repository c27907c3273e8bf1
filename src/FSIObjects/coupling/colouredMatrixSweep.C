// SPDX-License-Identifier: GPL-3.0-or-later

#include "colouredMatrix.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Rows that follow each other, and what they are relaxed with
struct relaxedRows
{
    const scalar* coefficient;
    const scalar* diagonal;
    const scalar* source;
    scalar* x;
    scalar relaxation;
};


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
    const scalar* __restrict__ coefficient = rows.coefficient;
    const scalar* __restrict__ diagonal = rows.diagonal;
    const scalar* __restrict__ source = rows.source;
    const scalar relaxation = rows.relaxation;

    // Values of a run are written, those of its neighbours read
    scalar* __restrict__ x = rows.x;
    const scalar* __restrict__ other[nSlots];
    for (int k = 0; k < nSlots; ++k)
    {
        other[k] = rows.x + nCmpts*offset[k];
    }

    scalar squares[nCmpts] = {};
    for (label row = first; row < last; ++row)
    {
        for (int d = 0; d < nCmpts; ++d)
        {
            const label i = nCmpts*row + d;
            scalar residual = source[i] - diagonal[i]*x[i];
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


//- The same for a number of components
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
      ? relaxRun<2>(rows, first, last, offset)
      : relaxRun<3>(rows, first, last, offset);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::colouredMatrix::exchange() const
{
    if (!Pstream::parRun())
    {
        return;
    }
    const polyBoundaryMesh& patches = grid_.mesh().boundaryMesh();
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    forAll(patches, patchi)
    {
        if (ghostStart_[patchi] >= 0)
        {
            const labelUList& cells = patches[patchi].faceCells();
            scalarField values(nDims_*cells.size());
            forAll(cells, i)
            {
                for (label d = 0; d < nDims_; ++d)
                {
                    values[nDims_*i + d] = value(rowOf_[cells[i]])[d];
                }
            }
            UOPstream to
            (
                refCast<const processorPolyPatch>(patches[patchi])
               .neighbProcNo(),
                buffers
            );
            to << patchi << values;
        }
    }
    buffers.finishedSends();
    forAll(patches, patchi)
    {
        if (ghostStart_[patchi] >= 0)
        {
            UIPstream from
            (
                refCast<const processorPolyPatch>(patches[patchi])
               .neighbProcNo(),
                buffers
            );
            label theirs;
            scalarField values;
            from >> theirs >> values;
            SubList<scalar>
            (
                x_,
                values.size(),
                nDims_*ghostStart_[patchi]
            ) = values;
        }
    }
}


Foam::FixedList<Foam::label, 6> Foam::fsi::colouredMatrix::offsets
(
    const labelUList& neighbourRow,
    const label row
) const
{
    const label* neighbour = neighbourRow.cdata() + nSlots_*row;
    FixedList<label, 6> offset(Zero);
    for (label k = 0; k < nSlots_; ++k)
    {
        if (neighbour[k] >= 0)
        {
            offset[k] = neighbour[k] - row;
        }
        else if (k > 0)
        {
            offset[k] = offset[0];
        }
    }
    return offset;
}


bool Foam::fsi::colouredMatrix::touchesOwnColour
(
    const FixedList<label, 6>& offset,
    const label row
) const
{
    for (label k = 0; k < nSlots_; ++k)
    {
        const label other = row + offset[k];
        if (other < rowOf_.size() && (other < nRed_) == (row < nRed_))
        {
            return true;
        }
    }
    return false;
}


void Foam::fsi::colouredMatrix::setRuns(const labelUList& neighbourRow)
{
    bool closed = true;
    forAll(rowOf_, row)
    {
        const FixedList<label, 6> offset(offsets(neighbourRow, row));
        const bool own = touchesOwnColour(offset, row);
        if (closed || own || row == nRed_ || runs_.last().offset != offset)
        {
            runs_.append(run{row, row, offset});
        }
        runs_.last().last = row + 1;
        if (row < nRed_)
        {
            nRedRuns_ = runs_.size();
        }
        closed = own;
    }
    runs_.shrink();
}


Foam::scalar Foam::fsi::colouredMatrix::relax
(
    const bool red,
    const scalar relaxation
)
{
    exchange();
    const relaxedRows rows
    {
        coefficient_.cdata(),
        diagonal_.cdata(),
        source_.cdata(),
        x_.data(),
        relaxation
    };
    const label end = red ? nRedRuns_ : runs_.size();
    scalar squares = 0;
    for (label runi = red ? 0 : nRedRuns_; runi < end; ++runi)
    {
        const run& r = runs_[runi];
        squares +=
            relaxRun(nDims_, rows, r.first, r.last, r.offset.cdata());
    }
    return squares;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::colouredMatrix::sweep(const scalar relaxation)
{
    scalar squares = relax(true, relaxation);
    squares += relax(false, relaxation);
    return Foam::sqrt(returnReduce(squares, sumOp<scalar>()));
}


Foam::scalar Foam::fsi::colouredMatrix::sweepFromZero
(
    const vectorField& source
)
{
    scalar squares = 0;
    forAll(rowOf_, celli)
    {
        const bool red = rowOf_[celli] < nRed_;
        const label place = nDims_*rowOf_[celli];
        for (label d = 0; d < nDims_; ++d)
        {
            const scalar b = source[celli][d];
            source_[place + d] = b;
            x_[place + d] = red ? b/diagonal_[place + d] : 0;
            squares += sqr(b);
        }
    }
    relax(false, 1);
    return Foam::sqrt(returnReduce(squares, sumOp<scalar>()));
}


Foam::scalar Foam::fsi::colouredMatrix::sourceNorm() const
{
    return Foam::sqrt(returnReduce(sumSqr(source_), sumOp<scalar>()));
}


// ************************************************************************* //
