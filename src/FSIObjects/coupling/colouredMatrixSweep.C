// SPDX-License-Identifier: GPL-3.0-or-later

#include "colouredMatrix.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"

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


template<int nCmpts>
Foam::scalar Foam::fsi::colouredMatrix::relax
(
    const label first,
    const label last,
    const scalar relaxation
)
{
    const label* __restrict__ neighbour = neighbourRow_.cdata();
    const scalar* __restrict__ coefficient = coefficient_.cdata();
    const scalar* __restrict__ diagonal = diagonal_.cdata();
    const scalar* __restrict__ source = source_.cdata();
    scalar* __restrict__ x = x_.data();
    constexpr int nSlots = 2*nCmpts;

    scalar squares = 0;
    for (label row = first; row < last; ++row)
    {
        scalar residual[nCmpts];
        const label place = nCmpts*row;
        for (int d = 0; d < nCmpts; ++d)
        {
            residual[d] = source[place + d] - diagonal[place + d]*x[place + d];
        }
        for (int k = 0; k < nSlots; ++k)
        {
            const scalar a = coefficient[nSlots*row + k];
            const scalar* other = x + nCmpts*neighbour[nSlots*row + k];
            for (int d = 0; d < nCmpts; ++d)
            {
                residual[d] -= a*other[d];
            }
        }
        for (int d = 0; d < nCmpts; ++d)
        {
            x[place + d] += relaxation*residual[d]/diagonal[place + d];
            squares += residual[d]*residual[d];
        }
    }
    return squares;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::colouredMatrix::sweep(const scalar relaxation)
{
    scalar squares = 0;
    for (const bool red : {true, false})
    {
        exchange();
        const label first = red ? 0 : nRed_;
        const label last = red ? nRed_ : rowOf_.size();
        squares +=
            nDims_ == 2
          ? relax<2>(first, last, relaxation)
          : relax<3>(first, last, relaxation);
    }
    return Foam::sqrt(returnReduce(squares, sumOp<scalar>()));
}


Foam::scalar Foam::fsi::colouredMatrix::sourceNorm() const
{
    return Foam::sqrt(returnReduce(sumSqr(source_), sumOp<scalar>()));
}


// ************************************************************************* //
