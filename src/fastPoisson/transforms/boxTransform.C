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

fftw_r2r_kind Foam::fsi::boxTransform::kind
(
    const direction d,
    const bool back
) const
{
    switch (ends_[d])
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
    const FixedList<ends, 3>& kinds
)
:
    n_(n),
    ends_(kinds),
    // One place more: cellTransfer's arrays have a spare one
    values_(fftw_alloc_real(size_t(n.x())*n.y()*n.z() + 1))
{
    // FFTW's last direction is the fastest; thin directions are left out
    int sizes[3];
    fftw_r2r_kind forward[3];
    fftw_r2r_kind backward[3];
    int rank = 0;
    for (int d = 2; d >= 0; --d)
    {
        if (n_[d] > 1)
        {
            sizes[rank] = n_[d];
            forward[rank] = kind(d, false);
            backward[rank] = kind(d, true);
            ++rank;
        }
    }
    const bool many = scalar(n.x())*n.y()*n.z() > manyCells;
    const unsigned effort = many ? FFTW_MEASURE : FFTW_ESTIMATE;
    fftw_set_timelimit(planningTime);
    forward_ = fftw_plan_r2r(rank, sizes, values_, values_, forward, effort);
    backward_ = fftw_plan_r2r(rank, sizes, values_, values_, backward, effort);
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::fsi::boxTransform::~boxTransform()
{
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(backward_);
    fftw_free(values_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::boxTransform::eigenvalues
(
    const direction d
) const
{
    using constant::mathematical::pi;
    const label n = n_[d];
    scalarField result(n, Zero);
    for (label m = 0; m < n && n > 1; ++m)
    {
        scalar wave = 0;
        switch (ends_[d])
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


Foam::scalar Foam::fsi::boxTransform::scale() const
{
    scalar result = 1;
    for (direction d = 0; d < 3; ++d)
    {
        if (n_[d] > 1)
        {
            result *= (ends_[d] == ends::cyclic ? 1 : 2)*scalar(n_[d]);
        }
    }
    return result;
}


// ************************************************************************* //
