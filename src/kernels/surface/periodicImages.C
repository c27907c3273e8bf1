// SPDX-License-Identifier: GPL-3.0-or-later

#include "openfoamVersion.H"
#include "periodicImages.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::periodicImages::longer
(
    const boundBox& bounds,
    const direction d,
    const scalar distance
) const
{
    return period_[d] > 0 && bounds.span()[d] + distance > period_[d];
}


void Foam::fsi::periodicImages::check
(
    const label objecti,
    const bool fixed,
    const boundBox& bounds,
    const scalar distance
) const
{
    for (direction d = 0; d < 3; ++d)
    {
        if (!longer(bounds, d, distance))
        {
            continue;
        }
        const bool through =
            bounds.min()[d] < domain_.min()[d] - distance
         && bounds.max()[d] > domain_.max()[d] + distance;
        if (!fixed)
        {
            FatalErrorInFunction
                << "Object " << objecti << " is " << bounds.span()[d]
                << " m long in direction " << label(d)
                << ", from " << bounds.min() << " to " << bounds.max()
                << ": with the gap of " << distance
                << " m (range of contact or band of the level set) to its own"
                << " image it does not fit into the period of the cyclic"
                << " patches, " << period_[d] << " m"
                << exit(FatalError);
        }
        else if (!through)
        {
            FatalErrorInFunction
                << "Fixed object " << objecti << ", from " << bounds.min()
                << " to " << bounds.max() << ", is longer than the period of"
                << " the cyclic patches, " << period_[d]
                << " m in direction " << label(d)
                << ". It must go through the domain, from below "
                << domain_.min()[d] - distance << " to above "
                << domain_.max()[d] + distance << " m"
                << exit(FatalError);
        }
    }
}


void Foam::fsi::periodicImages::findImages
(
    const label objecti,
    const boundBox& bounds,
    const boundBox& box,
    const scalar distance,
    const direction nDims,
    DynamicList<label>& originals,
    DynamicList<vector>& shifts
) const
{
    const auto steps = [&](const direction d)
    {
        return label
        (
            d < nDims && period_[d] > 0 && !longer(bounds, d, distance)
        );
    };

    labelVector n;
    for (n[2] = -steps(2); n[2] <= steps(2); ++n[2])
    {
        for (n[1] = -steps(1); n[1] <= steps(1); ++n[1])
        {
            for (n[0] = -steps(0); n[0] <= steps(0); ++n[0])
            {
                vector shift(Zero);
                bool near = n != labelVector::zero;
                for (direction d = 0; d < nDims; ++d)
                {
                    shift[d] = n[d]*period_[d];
                    near =
                        near
                     && bounds.min()[d] + shift[d] < box.max()[d]
                     && bounds.max()[d] + shift[d] > box.min()[d];
                }
                if (near)
                {
                    originals.append(objecti);
                    shifts.append(shift);
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::periodicImages::periodicImages()
:
    domain_(point::zero, point::zero),
    period_(Zero),
    all_(2)
{}


Foam::fsi::periodicImages::periodicImages
(
    const boundBox& domain,
    const vector& period
)
:
    domain_(domain),
    period_(period),
    all_(2)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::periodicImages::anyWalls(const surfaceSet& surfaces)
{
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (surfaces.hasWalls(objecti))
        {
            return true;
        }
    }
    return false;
}


const Foam::fsi::surfaceSet& Foam::fsi::periodicImages::update
(
    const surfaceSet& surfaces,
    const scalar distance
)
{
    if (!cyclic())
    {
        return surfaces;
    }

    // Images must come near to the domain or to what sticks out of it
    const vector margin(distance, distance, distance);
    boundBox box(domain_);
    List<boundBox> bounds(surfaces.size());
    forAll(bounds, objecti)
    {
        bounds[objecti] = surfaces.bounds(objecti);
        check(objecti, surfaces.fixed(objecti), bounds[objecti], distance);

        // A wall through the domain goes on as it is there
        boundBox out(bounds[objecti]);
        for (direction d = 0; d < 3; ++d)
        {
            if (longer(out, d, distance))
            {
                out.min()[d] = domain_.min()[d];
                out.max()[d] = domain_.max()[d];
            }
        }
        extend(box, out);
    }
    if (!anyWalls(surfaces))
    {
        // Only walls are seen through cyclic patches
        return surfaces;
    }
    box = boundBox(box.min() - margin, box.max() + margin);

    DynamicList<label> originals;
    DynamicList<vector> shifts;
    for (const bool fixed : {true, false})
    {
        forAll(bounds, objecti)
        {
            if (surfaces.fixed(objecti) == fixed)
            {
                findImages
                (
                    objecti,
                    bounds[objecti],
                    box,
                    distance,
                    surfaces.nDims(),
                    originals,
                    shifts
                );
            }
        }
    }

    all_ = surfaces;
    all_.appendImages(originals, shifts);
    return all_;
}


Foam::labelVector Foam::fsi::periodicImages::periodsOutside
(
    const point& p
) const
{
    labelVector n(0, 0, 0);
    for (direction d = 0; d < 3; ++d)
    {
        if (period_[d] > 0)
        {
            n[d] = label(floor((p[d] - domain_.min()[d])/period_[d]));
        }
    }
    return n;
}


// ************************************************************************* //
