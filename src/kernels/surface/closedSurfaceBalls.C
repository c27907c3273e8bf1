// SPDX-License-Identifier: GPL-3.0-or-later

#include "closedSurface.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::closedSurface::measure()
{
    surfaceSet alone(nDims_);
    alone.append(points_, *faces_);
    volume_ = alone.volume(0);
    centroid_ = alone.centroid(0);

    for (const point& p : points_)
    {
        outerRadius_ = max(outerRadius_, mag(p - centroid_));
    }
    if (contains(centroid_))
    {
        innerRadius_ = outerRadius_;
        FixedList<scalar, 3> weights;
        forAll(*faces_, facei)
        {
            const point nearest =
                alone.nearestOnFace(facei, centroid_, weights);
            innerRadius_ = min(innerRadius_, mag(nearest - centroid_));
        }
    }
}


Foam::scalar Foam::fsi::closedSurface::centreDistance
(
    const closedSurface& other
) const
{
    return mag(cmptMultiply(solved(), other.centroid_ - centroid_));
}


// * * * * * * * * * * * * Static Member Functions  * * * * * * * * * * * * * //

Foam::fsi::closedSurface::answer Foam::fsi::closedSurface::fromBalls
(
    const closedSurface& a,
    const closedSurface& b,
    const scalar apart,
    const scalar gap,
    const scalar scaleA,
    const scalar scaleB
)
{
    // More than round-off, so that the faces decide when it is close
    const scalar slack = 1e-9;
    const scalar outer = scaleA*a.outerRadius_ + scaleB*b.outerRadius_ + gap;
    const scalar inner = scaleA*a.innerRadius_ + scaleB*b.innerRadius_ + gap;
    if (apart > (1 + slack)*outer)
    {
        return NO;
    }
    const bool both = min(a.innerRadius_, b.innerRadius_) > 0;
    return both && apart < (1 - slack)*inner ? YES : UNKNOWN;
}


bool Foam::fsi::closedSurface::reaches(const boundBox& box) const
{
    for (const point& p : points_)
    {
        bool within = true;
        for (direction d = 0; d < nDims_; ++d)
        {
            within = within && p[d] > box.min()[d] && p[d] < box.max()[d];
        }
        if (within)
        {
            return true;
        }
    }
    return false;
}


// ************************************************************************* //
