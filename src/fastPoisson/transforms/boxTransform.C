// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxTransform.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

// FFTW tries out how to transform boxes of more cells than this ...
constexpr Foam::scalar manyCells = 20000;

// ... for at most so many seconds
constexpr double planningTime = 5;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

fftw_r2r_kind Foam::fsi::boxTransform::kind(const ends e, const bool back)
{
    switch (e)
    {
        case ends::gradient: return back ? FFTW_REDFT01 : FFTW_REDFT10;
        case ends::value: return back ? FFTW_RODFT01 : FFTW_RODFT10;
        case ends::valueLow: return FFTW_RODFT11;
        case ends::valueHigh: return FFTW_REDFT11;
        default: return back ? FFTW_HC2R : FFTW_R2HC;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::boxTransform::boxTransform
(
    const labelVector& n,
    const FixedList<ends, 3>& kinds,
    const FixedList<bool, 3>& use
)
:
    // One place more: cellTransfer's arrays have a spare one
    values_(fftw_alloc_real(size_t(n.x())*n.y()*n.z() + 1)),
    forward_(nullptr),
    backward_(nullptr)
{
    // Directions that are transformed and that are only gone through, FFTW's
    // last one the fastest; thin ones are left out
    fftw_iodim sizes[3], loops[3];
    fftw_r2r_kind forward[3], backward[3];
    int nSizes = 0;
    int nLoops = 0;
    for (int d = 2; d >= 0; --d)
    {
        const int stride = d == 0 ? 1 : d == 1 ? n.x() : n.x()*n.y();
        if (n[d] > 1 && use[d])
        {
            sizes[nSizes] = fftw_iodim{n[d], stride, stride};
            forward[nSizes] = kind(kinds[d], false);
            backward[nSizes] = kind(kinds[d], true);
            ++nSizes;
        }
        else if (n[d] > 1)
        {
            loops[nLoops++] = fftw_iodim{n[d], stride, stride};
        }
    }
    const scalar nCells = scalar(n.x())*n.y()*n.z();
    if (nSizes == 0 || nCells == 0)
    {
        return;
    }
    const unsigned effort = nCells > manyCells ? FFTW_MEASURE : FFTW_ESTIMATE;
    fftw_set_timelimit(planningTime);
    forward_ = fftw_plan_guru_r2r
    (
        nSizes, sizes, nLoops, loops, values_, values_, forward, effort
    );
    backward_ = fftw_plan_guru_r2r
    (
        nSizes, sizes, nLoops, loops, values_, values_, backward, effort
    );
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::fsi::boxTransform::~boxTransform()
{
    if (forward_)
    {
        fftw_destroy_plan(forward_);
        fftw_destroy_plan(backward_);
    }
    fftw_free(values_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::boxTransform::eigenvalues
(
    const label n,
    const ends e
)
{
    using constant::mathematical::pi;
    scalarField result(n, Zero);
    for (label m = 0; m < n && n > 1; ++m)
    {
        scalar wave = 0;
        switch (e)
        {
            case ends::gradient: wave = pi*m/n; break;
            case ends::value: wave = pi*(m + 1)/n; break;
            case ends::valueLow:
            case ends::valueHigh: wave = pi*(m + 0.5)/n; break;
            case ends::cyclic: wave = 2*pi*min(m, n - m)/n; break;
        }
        // 2 - 2 cos(w), exact for small w
        result[m] = 4*sqr(std::sin(wave/2));
    }
    return result;
}


Foam::scalar Foam::fsi::boxTransform::scale(const label n, const ends e)
{
    return n > 1 ? (e == ends::cyclic ? 1 : 2)*scalar(n) : 1;
}


// ************************************************************************* //
