// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectFeed.H"
#include "randomInPlane.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::fsi::outline> Foam::fsi::objectFeed::neighbours() const
{
    const surfaceSet& surfaces = objects_.surfaces();

    // What can be near an object that starts here
    const scalar reach =
        shape_.bounds().mag() + minimumGap_ + 3*grid_.spacing();
    const vector margin(reach, reach, 0);
    const boundBox box(bounds_.min() - margin, bounds_.max() + margin);

    DynamicList<outline> found;
    for (label objecti = 0; objecti < objects_.size(); ++objecti)
    {
        if (outline::near(surfaces.bounds(objecti), box, 0))
        {
            const shapeTemplate& shape =
                objects_.shape(objects_.objectGroup(objecti));
            found.append
            (
                outline
                (
                    SubList<point>
                    (
                        surfaces.points(),
                        shape.nBoundaryNodes(),
                        surfaces.pointStart()[objecti]
                    ),
                    shape.faces()
                )
            );
        }
    }
    return List<outline>(std::move(found));
}


bool Foam::fsi::objectFeed::findPlace
(
    Random& random,
    point& centre,
    tensor& rotation
) const
{
    const List<outline> others(neighbours());
    const direction normal = side_/2;
    const direction along = 1 - normal;
    for (label i = 0; i < maxAttempts_; ++i)
    {
        rotation = rotationAboutZ
        (
            randomRotation_ ? 360*random.sample01<scalar>() : rotation_
        );
        const boundBox box(shape_.moved(rotation, Zero).bounds());

        // Along the patch anywhere, and two cells outside it
        const scalar first = bounds_.min()[along] + sideGap_ - box.min()[along];
        const scalar last = bounds_.max()[along] - sideGap_ - box.max()[along];
        if (last < first)
        {
            continue;
        }
        centre = bounds_.centre();
        centre[along] = first + (last - first)*random.sample01<scalar>();
        centre[normal] =
            side_ % 2
          ? bounds_.max()[normal] + 2*grid_.spacing() - box.min()[normal]
          : bounds_.min()[normal] - 2*grid_.spacing() - box.max()[normal];

        const outline candidate(shape_.moved(rotation, centre));
        bool free = true;
        for (const outline& other : others)
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
    Random& random,
    const point& centre,
    const tensor& rotation
)
{
    const vector velocity
    (
        velocity_ + velocityPerturbation_*mag(velocity_)*randomInDisc(random)
    );
    const label id =
        objects_.append(group_, centre, rotation, velocity, angularVelocity_);
    ++nFed_;
    Info<< "Object " << id << " of shape " << objects_.shape(group_).name()
        << " fed at " << patch_ << ", centre " << centre << ", " << nFed_
        << " so far" << endl;
}


// ************************************************************************* //
