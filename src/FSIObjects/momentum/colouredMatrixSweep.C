// SPDX-License-Identifier: GPL-3.0-or-later

#include "colouredMatrix.H"
#include "colouredRows.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::fsi::colouredMatrix::exchange(Field<Type>& x) const
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
            Field<Type> values(nDims_*cells.size());
            forAll(cells, i)
            {
                for (label d = 0; d < nDims_; ++d)
                {
                    values[nDims_*i + d] = x[nDims_*rowOf_[cells[i]] + d];
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
            Field<Type> values;
            from >> theirs >> values;
            SubList<Type>
            (
                x,
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
    exchange(correction_);
    const relaxedRows rows
    {
        singleCoefficient_.cdata(),
        singleDiagonal_.cdata(),
        residual_.cdata(),
        correction_.data(),
        floatScalar(relaxation)
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


Foam::scalar Foam::fsi::colouredMatrix::norm(const scalar squares) const
{
    return Foam::sqrt(returnReduce(squares, sumOp<scalar>()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::colouredMatrix::startCorrection(const scalar norm)
{
    exchange(x_);
    correctionScale_ = 1/norm;
    const residualRows rows
    {
        coefficient_.cdata(),
        diagonal_.cdata(),
        source_.cdata(),
        x_.cdata(),
        singleCoefficient_.data(),
        singleDiagonal_.data(),
        residual_.data(),
        correctionScale_
    };
    for (const run& r : runs_)
    {
        residualRun(nDims_, rows, r.first, r.last, r.offset.cdata());
    }
    nSweeps_ = 0;
}


Foam::scalar Foam::fsi::colouredMatrix::startFromZero
(
    const vectorField& source
)
{
    scalar squares = 0;
    for (const vector& s : source)
    {
        for (label d = 0; d < nDims_; ++d)
        {
            squares += sqr(s[d]);
        }
    }
    const scalar sourceNorm = norm(squares);
    correctionScale_ = 1/(sourceNorm + VSMALL);
    forAll(rowOf_, celli)
    {
        const bool red = rowOf_[celli] < nRed_;
        const label place = nDims_*rowOf_[celli];
        for (label d = 0; d < nDims_; ++d)
        {
            const floatScalar b(correctionScale_*source[celli][d]);
            source_[place + d] = source[celli][d];
            x_[place + d] = 0;
            residual_[place + d] = b;
            correction_[place + d] = red ? b/singleDiagonal_[place + d] : 0;
        }
    }
    relax(false, 1);
    nSweeps_ = 1;
    firstResidual_ = lastResidual_ = 1;
    return sourceNorm;
}


Foam::scalar Foam::fsi::colouredMatrix::sweep(const scalar relaxation)
{
    scalar squares = relax(true, relaxation);
    squares += relax(false, relaxation);
    lastResidual_ = norm(squares);
    if (nSweeps_++ == 0)
    {
        firstResidual_ = lastResidual_;
    }
    return lastResidual_;
}


Foam::scalar Foam::fsi::colouredMatrix::dropAtOnce() const
{
    // The residual's rounding error is that of diagonal times correction,
    // which is the residual over 1 - jacobiRadius at most. 30 times away from
    // it nothing shows
    const scalar rounding =
        std::numeric_limits<floatScalar>::epsilon()
       /max(1 - jacobiRadius_, SMALL);
    return min(30*rounding, scalar(0.1));
}


void Foam::fsi::colouredMatrix::addCorrection()
{
    const scalar scale = 1/correctionScale_;
    const label nValues = source_.size();
    for (label i = 0; i < nValues; ++i)
    {
        x_[i] += scale*correction_[i];
    }
    correction_ = 0;
}


bool Foam::fsi::colouredMatrix::exhausted() const
{
    return
        nSweeps_ >= maxSweeps
     || (nSweeps_ > 0 && lastResidual_ < dropAtOnce()*firstResidual_);
}


Foam::scalar Foam::fsi::colouredMatrix::sourceNorm() const
{
    return norm(sumSqr(source_));
}


// ************************************************************************* //
