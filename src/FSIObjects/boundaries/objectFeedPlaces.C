// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectFeed.H"
#include "nearSurfaces.H"
#include "rotations.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::objectFeed::findPlace
(
    randomNumbers& random,
    point& centre,
    tensor& rotation
) const
{
    // Only objects within this reach can touch one that starts here
    const closedSurface& shape = shapes_.surface(shapes_.next());
    const scalar reach =
        shape.bounds().mag() + minimumGap_ + 3*grid_.spacing();
    const vector margin(reach, reach, reach);
    const boundBox near(bounds_.min() - margin, bounds_.max() + margin);
    const std::vector<closedSurface> others(nearSurfaces(objects_, near));
    const direction normal = side_/2;
    for (label i = 0; i < maxAttempts_; ++i)
    {
        rotation =
            randomRotation_
          ? randomRotation(random, objects_.nDims())
          : rotation_;
        const boundBox box(shape.moved(rotation, Zero).bounds());

        // Along the patch anywhere, and two cells outside it
        centre = centreOf(bounds_);
        bool fits = true;
        for (direction d = 0; d < 3 && fits; ++d)
        {
            if (along(d))
            {
                const scalar first =
                    bounds_.min()[d] + sideGap_ - box.min()[d];
                const scalar last = bounds_.max()[d] - sideGap_ - box.max()[d];
                fits = first <= last;
                if (fits)
                {
                    centre[d] =
                        first + (last - first)*random.sample01<scalar>();
                }
            }
        }
        if (!fits)
        {
            continue;
        }
        centre[normal] =
            side_ % 2
          ? bounds_.max()[normal] + 2*grid_.spacing() - box.min()[normal]
          : bounds_.min()[normal] - 2*grid_.spacing() - box.max()[normal];

        const closedSurface candidate(shape.moved(rotation, centre));
        // An opening may be no rectangle
        bool free = !sides_.behindWall(candidate.points());
        for (const closedSurface& other : others)
        {
            free = free && !candidate.closerThan(other, minimumGap_);
        }
        if (free)
        {
            return true;
        }
    }
    return false;
}


void Foam::fsi::objectFeed::feed
(
    randomNumbers& random,
    const point& centre,
    const tensor& rotation
)
{
    const vector velocity
    (
        velocity_
      + velocityPerturbation_*mag(velocity_)
       *randomInBall(random, objects_.nDims())
    );
    const label shapei = shapes_.next();
    const label id = objects_.append
    (
        shapes_.group(shapei), centre, rotation, velocity, angularVelocity_
    );
    shapes_.advance(1);
    Info<< "Object " << id << " of shape " << shapes_.name(shapei) << " fed at "
        << patch_ << ", centre " << centre << ", " << nFed() << " so far"
        << endl;
}


// ************************************************************************* //
