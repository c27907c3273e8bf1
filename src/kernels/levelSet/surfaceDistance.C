// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceDistance.H"
#include "fetchSamples.H"
#include "sortedObjects.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceDistance::check
(
    const surfaceSet& surfaces,
    const cartesianBlock& block
) const
{
    if (surfaces.nDims() != block.nDims())
    {
        FatalErrorInFunction
            << "Surfaces in " << label(surfaces.nDims())
            << " dimensions on a block in " << label(block.nDims())
            << exit(FatalError);
    }
    forAll(surfaces.points(), nodei)
    {
        if (!std::isfinite(magSqr(surfaces.points()[nodei])))
        {
            FatalErrorInFunction
                << "Node " << nodei << " of object "
                << surfaces.pointObject()[nodei] << " is at "
                << surfaces.points()[nodei] << exit(FatalError);
        }
    }
}


Foam::boundBox Foam::fsi::surfaceDistance::reach
(
    const surfaceSet& surfaces,
    const label objecti
) const
{
    // A little wider, for round-off
    const boundBox bounds(surfaces.bounds(objecti));
    const vector width(vector::uniform(1.001*bandWidth_));
    return boundBox(bounds.min() - width, bounds.max() + width);
}


void Foam::fsi::surfaceDistance::addObjects
(
    const surfaceSet& surfaces,
    const cartesianBlock& block,
    const bool fixed
)
{
    for (const label objecti : sortedObjects(surfaces))
    {
        if (surfaces.fixed(objecti) != fixed || !surfaces.hasWalls(objecti))
        {
            continue;
        }
        near_.firstFace = surfaces.faceStart()[objecti];
        near_.endFace = surfaces.faceStart()[objecti + 1];
        const boundBox box(reach(surfaces, objecti));
        if (fetchSamples(block, box.min(), box.max(), near_.distance))
        {
            if (surfaces.nDims() == 2)
            {
                addSegments(surfaces, objecti, block);
            }
            else
            {
                addTriangles(surfaces, objecti, block);
            }
            inside_.mark(surfaces, objecti, block, object_);
        }
    }
}


void Foam::fsi::surfaceDistance::setFixed(const sampleRanges& samples)
{
    for (const labelPair& r : samples.ranges())
    {
        fixed_.copy
        (
            r.first(),
            r.second(),
            {&near_.distance, &near_.secondDistance},
            {&near_.face, &object_, &near_.secondFace}
        );
    }
}


void Foam::fsi::surfaceDistance::finish
(
    const surfaceSet& surfaces,
    const sampleRanges& samples
)
{
    for (const labelPair& r : samples.ranges())
    {
        for (label samplei = r.first(); samplei < r.second(); ++samplei)
        {
            const bool inside = object_[samplei] >= 0;
            scalar distance = bandWidth_;
            if (near_.face[samplei] >= 0)
            {
                distance = sqrt(near_.distance[samplei]);
                object_[samplei] = surfaces.faceObject()[near_.face[samplei]];
            }
            near_.secondDistance[samplei] = sqrt(near_.secondDistance[samplei]);
            if (object_[samplei] >= 0)
            {
                object_[samplei] = surfaces.original(object_[samplei]);
            }
            near_.distance[samplei] = inside ? -distance : distance;
        }
    }
}


void Foam::fsi::surfaceDistance::restart
(
    const surfaceSet& surfaces,
    const cartesianBlock& block
)
{
    near_.reset(block.size(), sqr(bandWidth_));
    object_.setSize(block.size());
    object_ = -1;

    addObjects(surfaces, block, true);
    fixed_.keep
    (
        surfaces,
        block,
        sqr(bandWidth_),
        {&near_.distance, &near_.secondDistance},
        {&near_.face, &object_, &near_.secondFace}
    );
    touched_ = sampleRanges(block);
    finish(surfaces, touched_);
    touched_.clear();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceDistance::surfaceDistance(const scalar bandWidth)
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

void Foam::fsi::surfaceDistance::update
(
    const surfaceSet& surfaces,
    const cartesianBlock& block
)
{
    check(surfaces, block);
    if
    (
        near_.distance.size() != block.size()
     || !fixed_.hold(surfaces, block)
    )
    {
        restart(surfaces, block);
    }

    sampleRanges touched;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (!surfaces.fixed(objecti) && surfaces.hasWalls(objecti))
        {
            const boundBox box(reach(surfaces, objecti));
            touched.add(block, box.min(), box.max());
        }
    }
    touched.merge(block);

    // Where objects were, unless all is set below
    if (touched.nSamples() < block.size())
    {
        setFixed(touched_);
        finish(surfaces, touched_);
    }
    touched_.swap(touched);
    setFixed(touched_);
    addObjects(surfaces, block, false);
    finish(surfaces, touched_);
}


void Foam::fsi::surfaceDistance::extendVelocity
(
    const surfaceSet& surfaces,
    const cartesianBlock& block,
    vectorField& velocity
) const
{
    velocity.setSize(block.size());
    FixedList<scalar, 3> weights;
    forAll(near_.face, samplei)
    {
        velocity[samplei] = Zero;
        if (near_.face[samplei] >= 0)
        {
            surfaces.nearestOnFace
            (
                near_.face[samplei],
                block.position(samplei),
                weights
            );
            velocity[samplei] = surfaces.interpolate
            (
                surfaces.velocities(),
                near_.face[samplei],
                weights
            );
        }
    }
}


// ************************************************************************* //
