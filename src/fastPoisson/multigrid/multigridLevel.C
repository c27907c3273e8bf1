// SPDX-License-Identifier: GPL-3.0-or-later

#include "multigridLevel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

float Foam::fsi::multigridLevel::faceSum(const label place) const
{
    float sum = 0;
    for (direction d = 0; d < (A_.threeD ? 3 : 2); ++d)
    {
        sum += face_[d][place] + face_[d][place + layout_.stride(d)];
    }
    return sum;
}


void Foam::fsi::multigridLevel::addRowTo
(
    const label r,
    const levelShift shift,
    multigridLevel& coarse
) const
{
    const label j = r % A_.ny;
    const label k = r/A_.ny;
    const label from = A_.row(r);
    const label to = coarse.layout_.index(0, j >> shift.y, k >> shift.z);

    // Is this row, or cell, the first of its aggregate
    const bool firstY = (j >> shift.y) << shift.y == j;
    const bool firstZ = (k >> shift.z) << shift.z == k;
    const float weightX = shift.x ? 0.5f : 1.0f;
    const float weightY = firstY ? (shift.y ? 0.5f : 1.0f) : 0.0f;
    const float weightZ = firstZ ? (shift.z ? 0.5f : 1.0f) : 0.0f;
    const label step = 1 << shift.x;

    for (label i = 0; i < A_.nx; ++i)
    {
        // A cell on its own is solved on this level
        const float sum = diagonal_[from + i] - excess_[from + i];
        const label place = to + (i >> shift.x);
        coarse.excess_[place] += sum > 0 ? excess_[from + i] : 0.0f;
        coarse.face_[1][place] += weightY*face_[1][from + i];
        if (A_.threeD)
        {
            coarse.face_[2][place] += weightZ*face_[2][from + i];
        }
    }
    for (label i = 0; i < A_.nx; i += step)
    {
        coarse.face_[0][to + (i >> shift.x)] += weightX*face_[0][from + i];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::multigridLevel::multigridLevel
(
    const blockPartition& partition,
    const label rank,
    const label comm
)
:
    partition_(partition),
    layout_(partition.layout(rank)),
    halo_(layout_, comm),
    A_(layout_)
{
    const label size = layout_.size();
    for (direction d = 0; d < 3; ++d)
    {
        // Without a third direction its pointer is valid but not used
        const bool used = d < 2 || A_.threeD;
        face_[d].setSize(used ? size : 0, 0.0f);
        A_.face[d] = face_[used ? d : 0].cdata();
    }
    for
    (
        List<float>* array :
        {&excess_, &diagonal_, &inverse_, &x_, &b_, &work_}
    )
    {
        array->setSize(size, 0.0f);
    }
    work_.setSize(layout_.n().x() + 2, 0.0f);
    A_.diagonal = diagonal_.cdata();
    A_.inverse = inverse_.cdata();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::multigridLevel::finish()
{
    for (direction d = 0; d < (A_.threeD ? 3 : 2); ++d)
    {
        halo_.fillHigh(d, face_[d].data());
    }
    for (label r = 0; r < A_.ny*A_.nz; ++r)
    {
        const label row = A_.row(r);
        for (label place = row; place < row + A_.nx; ++place)
        {
            const float sum = faceSum(place);
            const float diagonal = sum + excess_[place];
            diagonal_[place] = diagonal;
            inverse_[place] = diagonal > 0 ? 1.0f/diagonal : 0.0f;
        }
    }
}


void Foam::fsi::multigridLevel::coarsen
(
    const levelShift shift,
    multigridLevel& coarse
) const
{
    coarse.excess_ = 0;
    for (List<float>& face : coarse.face_)
    {
        face = 0;
    }
    for (label r = 0; r < A_.ny*A_.nz; ++r)
    {
        addRowTo(r, shift, coarse);
    }

    // Cyclic, and one cell long: a cell does not couple with itself
    for (direction d = 0; d < 3; ++d)
    {
        if (coarse.partition_.n(d) == 1)
        {
            coarse.face_[d] = 0;
        }
    }
    coarse.finish();
}


void Foam::fsi::multigridLevel::smoothDown(const bool fromZero)
{
    const float* b = b_.cdata();
    float* x = x_.data();
    if (!layout_.coupled())
    {
        if (fromZero)
        {
            sweepsFromZero(A_, b, x, work_.data());
        }
        else
        {
            sweeps(A_, 0, b, x, work_.data());
        }
        return;
    }

    if (fromZero)
    {
        sweepFromZero(A_, 0, b, x);
    }
    else
    {
        halo_.fill(x);
        sweep(A_, 0, b, x, work_.data());
    }
    halo_.fill(x);
    sweep(A_, 1, b, x, work_.data());
    halo_.fill(x);
}


void Foam::fsi::multigridLevel::smoothUp()
{
    const float* b = b_.cdata();
    float* x = x_.data();
    if (!layout_.coupled())
    {
        sweeps(A_, 1, b, x, work_.data());
        return;
    }
    halo_.fill(x);
    sweep(A_, 1, b, x, work_.data());
    halo_.fill(x);
    sweep(A_, 0, b, x, work_.data());
}


void Foam::fsi::multigridLevel::restrictTo
(
    const levelShift shift,
    multigridLevel& coarse
)
{
    restrictResidual
    (
        A_, b_.cdata(), x_.cdata(), coarse.A_, shift,
        coarse.b_.data(), work_.data()
    );
}


void Foam::fsi::multigridLevel::correctFrom
(
    const levelShift shift,
    const multigridLevel& coarse
)
{
    addCoarse(A_, coarse.A_, shift, coarse.x_.cdata(), x_.data());
}


// ************************************************************************* //
