// SPDX-License-Identifier: GPL-3.0-or-later

#include "levelSetAdvection.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- 1 up to the distance inner, 0 from outer on, a cubic between
static scalar fade
(
    const scalar distance,
    const scalar inner,
    const scalar outer
)
{
    if (distance <= inner)
    {
        return 1;
    }
    if (distance >= outer)
    {
        return 0;
    }
    return
        sqr(distance - outer)*(2*distance + outer - 3*inner)
       /pow3(outer - inner);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::levelSetAdvection::setBand
(
    const cartesianBlock& block,
    const vectorField& velocity,
    const scalarField& phi
)
{
    const scalar inner = max(bandWidth_ - 3*block.spacing(), 0.0);
    labelVector first(halo, halo, halo);
    if (block.nDims() == 2)
    {
        first.z() = 0;
    }
    const labelVector end(block.n() - first);

    band_.clear();
    velocity_.clear();
    entry_.clear();
    for (label k = first.z(); k < end.z(); ++k)
    {
        for (label j = first.y(); j < end.y(); ++j)
        {
            for (label i = first.x(); i < end.x(); ++i)
            {
                const label samplei = block.index(i, j, k);
                const scalar distance = mag(phi[samplei]);
                if (distance < bandWidth_)
                {
                    band_.append(samplei);
                    entry_.append(phi[samplei]);
                    velocity_.append
                    (
                        fade(distance, inner, bandWidth_)*velocity[samplei]
                    );
                }
            }
        }
    }
    rate_.setSize(band_.size());
}


void Foam::fsi::levelSetAdvection::check
(
    const cartesianBlock& block,
    const scalar deltaT,
    const scalarField& phi
) const
{
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        if (block.n()[dir] <= 2*halo)
        {
            FatalErrorInFunction
                << "The block has " << block.n() << " samples but needs more"
                << " than " << 2*halo << " in each direction"
                << exit(FatalError);
        }
    }
    forAll(phi, samplei)
    {
        if (!std::isfinite(phi[samplei]))
        {
            FatalErrorInFunction
                << "The level set is " << phi[samplei] << " at "
                << block.position(samplei)
                << exit(FatalError);
        }
    }
    forAll(velocity_, i)
    {
        vector v(velocity_[i]);
        if (block.nDims() == 2)
        {
            v.z() = 0;
        }
        const scalar courant =
            cmptSum(cmptMag(v))*deltaT/block.spacing();
        if (!(courant <= 1))
        {
            FatalErrorInFunction
                << "The Courant number of the level set is " << courant
                << " at " << block.position(band_[i])
                << " but must not be above 1"
                << exit(FatalError);
        }
    }
}


void Foam::fsi::levelSetAdvection::stage
(
    const cartesianBlock& block,
    const scalar part,
    const scalar deltaT,
    scalarField& phi
)
{
    forAll(band_, i)
    {
        rate_[i] = 0;
        for (direction dir = 0; dir < block.nDims(); ++dir)
        {
            const scalar v = velocity_[i][dir];
            if (v != 0)
            {
                rate_[i] -= v*derivative
                (
                    &phi[band_[i]],
                    block.stride(dir),
                    block.spacing(),
                    v > 0
                );
            }
        }
    }
    forAll(band_, i)
    {
        scalar& value = phi[band_[i]];
        value = part*entry_[i] + (1 - part)*(value + deltaT*rate_[i]);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::fsi::levelSetAdvection::derivative
(
    const scalar* values,
    const label stride,
    const scalar spacing,
    const bool fromBelow
)
{
    // Mirrored if the velocity comes from above: u[i] is i samples upwind
    const label s = fromBelow ? -stride : stride;
    const auto u = [&](const label i) { return values[i*s]; };
    const auto second = [&](const label i)
    {
        return u(i + 1) - 2*u(i) + u(i - 1);
    };

    // Differences of u in the upwind direction. Newton's form: first the
    // interval 0..1, then the smaller second difference at 0 or 1, then the
    // smaller third difference beside that
    scalar sum = u(1) - u(0);

    const bool near = mag(second(0)) <= mag(second(1));
    const label centre = near ? 0 : 1;
    sum -= 0.5*second(centre);

    const scalar lower = second(centre) - second(centre - 1);
    const scalar upper = second(centre + 1) - second(centre);
    const scalar third = mag(lower) <= mag(upper) ? lower : upper;
    sum += near ? -third/6 : third/3;

    return (fromBelow ? -sum : sum)/spacing;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::levelSetAdvection::levelSetAdvection(const scalar bandWidth)
:
    bandWidth_(bandWidth)
{
    if (!(bandWidth > 0))
    {
        FatalErrorInFunction
            << "The width of the band is " << bandWidth << " but must be > 0"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::levelSetAdvection::advance
(
    const cartesianBlock& block,
    const vectorField& velocity,
    const scalar deltaT,
    scalarField& phi,
    const std::function<void(scalarField&)>& fillHalo
)
{
    setBand(block, velocity, phi);
    check(block, deltaT, phi);

    for (const scalar part : {0.0, 3.0/4.0, 1.0/3.0})
    {
        stage(block, part, deltaT, phi);
        fillHalo(phi);
    }
}


// ************************************************************************* //
