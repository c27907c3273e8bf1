// SPDX-License-Identifier: GPL-3.0-or-later

#include "redBlackMatrix.H"
#include "redBlackRuns.H"
#include "sumOverRanks.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::redBlackMatrix::relax
(
    const bool red,
    const scalar relaxation
)
{
    order_.exchange(correction_);
    const relaxedRows rows
    {
        singleCoefficient_.cdata(),
        singleDiagonal_.cdata(),
        residual_.cdata(),
        correction_.data(),
        floatScalar(relaxation)
    };
    scalar squares = 0;
    for (const redBlackRun& r : order_.runs(red))
    {
        squares +=
            relaxRun(nDims_, rows, r.first, r.last, r.offset.cdata());
    }
    return squares;
}


Foam::scalar Foam::fsi::redBlackMatrix::norm(const scalar squares) const
{
    return Foam::sqrt(overRanks(squares, sumOp<scalar>()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::redBlackMatrix::startCorrection(const scalar norm)
{
    order_.exchange(x_);
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
    for (const redBlackRun& r : order_.runs())
    {
        residualRun(nDims_, rows, r.first, r.last, r.offset.cdata());
    }
    nSweeps_ = 0;
}


Foam::scalar Foam::fsi::redBlackMatrix::startFromZero
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
    const labelUList& rowOf = order_.rowOf();
    forAll(rowOf, celli)
    {
        const bool red = order_.red(rowOf[celli]);
        const label place = nDims_*rowOf[celli];
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


Foam::scalar Foam::fsi::redBlackMatrix::startFrom
(
    const vectorField& source,
    const vectorField& guess
)
{
    const labelUList& rowOf = order_.rowOf();
    forAll(rowOf, celli)
    {
        const label place = nDims_*rowOf[celli];
        for (label d = 0; d < nDims_; ++d)
        {
            source_[place + d] = source[celli][d];
            x_[place + d] = guess[celli][d];
        }
    }
    correction_ = 0;
    const scalar norm = sourceNorm();
    startCorrection(norm + VSMALL);
    return norm;
}


Foam::scalar Foam::fsi::redBlackMatrix::sweep
(
    const scalar relaxation,
    const scalar others
)
{
    const scalar ofRed = relax(true, relaxation);
    lastResidual_ = norm(ofRed + relax(false, relaxation) + others);
    if (nSweeps_++ == 0)
    {
        firstResidual_ = lastResidual_;
    }
    return lastResidual_;
}


Foam::scalar Foam::fsi::redBlackMatrix::dropAtOnce() const
{
    // The residual's rounding error is that of diagonal times correction,
    // which is the residual over 1 - jacobiRadius at most. 30 times away from
    // it nothing shows
    const scalar rounding =
        std::numeric_limits<floatScalar>::epsilon()
       /max(1 - radii_[0], SMALL);
    return min(30*rounding, scalar(0.1));
}


void Foam::fsi::redBlackMatrix::addCorrection()
{
    const scalar scale = 1/correctionScale_;
    forAll(source_, i)
    {
        x_[i] += scale*correction_[i];
    }
    correction_ = 0;
}


bool Foam::fsi::redBlackMatrix::exhausted() const
{
    return
        nSweeps_ >= maxSweeps
     || (nSweeps_ > 0 && lastResidual_ < dropAtOnce()*firstResidual_);
}


// ************************************************************************* //
