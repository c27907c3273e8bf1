// SPDX-License-Identifier: GPL-3.0-or-later

#include "multigridLevel.H"
#include "stencilCycle.H"
#include "stencilSetup.H"

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
    setDiagonal(A_, excess_.cdata(), diagonal_.data(), inverse_.data());
}


void Foam::fsi::multigridLevel::coarsen
(
    const levelShift shift,
    multigridLevel& coarse
)
{
    coarse.excess_ = 0;
    for (List<float>& face : coarse.face_)
    {
        face = 0;
    }
    float* const face[3] =
    {
        coarse.face_[0].data(), coarse.face_[1].data(), coarse.face_[2].data()
    };
    coarsenCoefficients
    (
        A_, excess_.cdata(), coarse.A_, shift, face, coarse.excess_.data(),
        work_.data()
    );

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


void Foam::fsi::multigridLevel::down
(
    const bool fromZero,
    const levelShift shift,
    multigridLevel& coarse
)
{
    const float* b = b_.cdata();
    float* x = x_.data();
    float* coarseB = coarse.b_.data();
    float* work = work_.data();
    if (!layout_.coupled())
    {
        downwards(A_, fromZero, b, x, coarse.A_, shift, coarseB, work);
        return;
    }

    if (fromZero)
    {
        sweepFromZero(A_, 0, b, x);
    }
    else
    {
        halo_.fill(x);
        sweep(A_, 0, b, x, work);
    }
    halo_.fill(x);
    sweep(A_, 1, b, x, work);
    halo_.fill(x);
    restrictResidual(A_, b, x, coarse.A_, shift, coarseB, work);
}


void Foam::fsi::multigridLevel::restrictSource
(
    const levelShift shift,
    multigridLevel& coarse
)
{
    fsi::restrictSource
    (
        A_, b_.cdata(), coarse.A_, shift, coarse.b_.data(), work_.data()
    );
}


void Foam::fsi::multigridLevel::interpolate
(
    const levelShift shift,
    const multigridLevel& coarse
)
{
    x_ = 0;
    addCoarse(A_, coarse.A_, shift, coarse.x_.cdata(), x_.data());
}


void Foam::fsi::multigridLevel::up
(
    const levelShift shift,
    const multigridLevel& coarse
)
{
    const float* b = b_.cdata();
    const float* coarseX = coarse.x_.cdata();
    float* x = x_.data();
    float* work = work_.data();
    if (!layout_.coupled())
    {
        upwards(A_, b, x, coarse.A_, shift, coarseX, work);
        return;
    }
    addCoarse(A_, coarse.A_, shift, coarseX, x);
    halo_.fill(x);
    sweep(A_, 1, b, x, work);
    halo_.fill(x);
    sweep(A_, 0, b, x, work);
}


// ************************************************************************* //
