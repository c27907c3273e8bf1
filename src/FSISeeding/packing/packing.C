// SPDX-License-Identifier: GPL-3.0-or-later

#include "packing.H"
#include "openfoamVersion.H"
#include "OStringStream.H"
#include "nullBox.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Size of grid cells: about that of the smallest shape [m]
static scalar gridSize(const UList<closedSurface>& shapes, const scalar h)
{
    scalar size = GREAT;
    for (const closedSurface& s : shapes)
    {
        size = min(size, max(s.bounds().span().x(), 3*h));
    }
    return size;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::packing::ball Foam::fsi::packing::ballOf
(
    const placedObject& object,
    const vector& shift
) const
{
    const closedSurface& shape = shapes_[object.shape];
    const scalar scale = object.scale;
    const vector offset(scale*(object.rotation & shape.centroid()));
    const point centre(offset + object.centre + shift);
    const scalar r = (1 + 1e-9)*scale*shape.outerRadius();
    const boundBox box(centre - vector(r, r, r), centre + vector(r, r, r));
    return {centre, object.shape, scale, box};
}


Foam::label Foam::fsi::packing::findConflict
(
    const placedObject& object,
    const vector& shift,
    const scalar gap,
    const label except
) const
{
    const ball candidate(ballOf(object, shift));
    if
    (
        !closedSurface::near(candidate.box, occupied_, gap, nDims())
     || (
            attached(object.shape)
         && goesThrough(object.shape, placed(object).bounds(), shift)
        )
    )
    {
        return -1;
    }
    closedSurface surface;
    const auto isCloser = [&](const label objecti)
    {
        const ball& other = balls_[objecti];
        if
        (
            objecti == except
         || goesThrough(other.shape, other.box, shift)
         || !closedSurface::near(candidate.box, other.box, gap, nDims())
        )
        {
            return false;
        }
        vector apart(other.centre - candidate.centre);
        apart.z() = nDims() == 2 ? 0 : apart.z();
        const auto known = closedSurface::fromBalls
        (
            shapes_[object.shape], shapes_[other.shape], mag(apart), gap,
            candidate.scale, other.scale
        );
        if (known == closedSurface::UNKNOWN && surface.points().empty())
        {
            surface = placed(object).moved(tensor::I, shift);
        }
        return
            known == closedSurface::UNKNOWN
          ? surface.closerThan(this->surface(objecti), gap)
          : known == closedSurface::YES;
    };
    const vector margin(gap, gap, gap);
    return grid_.find
    (
        boundBox(candidate.box.min() - margin, candidate.box.max() + margin),
        isCloser
    );
}


void Foam::fsi::packing::enter(const label objecti)
{
    extend(occupied_, balls_[objecti].box);
    grid_.enter(objecti, balls_[objecti].box);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::packing::packing
(
    const boundBox& domain,
    const scalar spacing,
    const wordList& shapeNames,
    const List<closedSurface>& shapes,
    const vector& period,
    const boolList& attached,
    const pointField& places,
    const boolList& immersed
)
:
    domain_(domain),
    spacing_(spacing),
    shapeNames_(shapeNames),
    shapes_(shapes),
    period_(period),
    attached_(attached),
    immersed_(immersed),
    places_(places),
    shifts_(1, Zero),
    occupied_(nullBox()),
    grid_(domain, gridSize(shapes, spacing), nDims())
{
    for (direction d = 0; d < nDims(); ++d)
    {
        const label n = period_[d] > 0 ? shifts_.size() : 0;
        for (label i = 0; i < n; ++i)
        {
            for (const scalar shift : {-period_[d], period_[d]})
            {
                vector image(shifts_[i]);
                image[d] = shift;
                shifts_.append(image);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsi::packing::description(const label objecti) const
{
    const placedObject& object = objects_[objecti];
    OStringStream os;
    os  << "object " << objecti << " (" << shapeNames_[object.shape].c_str()
        << " of placement " << object.placement.c_str() << ", centre "
        << object.centre << ')';
    return os.str();
}


Foam::fsi::closedSurface Foam::fsi::packing::placed
(
    const placedObject& object
) const
{
    return shapes_[object.shape].moved
    (
        object.rotation, object.centre, object.scale
    );
}


const Foam::fsi::closedSurface& Foam::fsi::packing::surface
(
    const label objecti
) const
{
    if (surfaces_[objecti].points().empty())
    {
        surfaces_[objecti] = placed(objects_[objecti]);
    }
    return surfaces_[objecti];
}


Foam::label Foam::fsi::packing::findConflict
(
    const placedObject& object,
    const scalar gap,
    const label except
) const
{
    for (const vector& shift : shifts_)
    {
        const label found = findConflict(object, shift, gap, except);
        if (found >= 0)
        {
            return found;
        }
    }
    return -1;
}


Foam::scalar Foam::fsi::packing::distance
(
    const closedSurface& candidate,
    const label objecti,
    const scalar limit
) const
{
    const ball& other = balls_[objecti];
    scalar least = limit;
    for (const vector& shift : shifts_)
    {
        const closedSurface image(candidate.moved(tensor::I, shift));
        const scalar d = image.distance(surface(objecti), least);
        least = goesThrough(other.shape, other.box, shift) ? least : d;
    }
    return least;
}


bool Foam::fsi::packing::inside
(
    const placedObject& object,
    const boundBox& box
) const
{
    const boundBox own(ballOf(object).box);
    bool held = true;
    for (direction d = 0; d < nDims(); ++d)
    {
        held = held
         && own.min()[d] >= box.min()[d]
         && own.max()[d] <= box.max()[d];
    }
    return held || placed(object).inside(box, 0);
}


bool Foam::fsi::packing::inDomain
(
    const placedObject& object,
    const closedSurface& candidate,
    const scalar gap
) const
{
    const point& centre = object.centre;
    boundBox box(domain_);
    for (direction d = 0; d < nDims(); ++d)
    {
        if (period_[d] > 0)
        {
            if (!(centre[d] >= box.min()[d] && centre[d] <= box.max()[d]))
            {
                return false;
            }
            box.min()[d] = -GREAT;
            box.max()[d] = GREAT;
        }
    }
    if (gap <= 0 && attached(object.shape))
    {
        return candidate.reaches(box);
    }
    return candidate.inside(box, gap);
}


Foam::label Foam::fsi::packing::insert(const placedObject& object)
{
    objects_.append(object);
    surfaces_.append(placed(object));
    balls_.append(ballOf(object));
    balls_.last().box = surfaces_.last().bounds();
    enter(size() - 1);
    return size() - 1;
}


void Foam::fsi::packing::move(const label objecti, const placedObject& object)
{
    grid_.takeOut(objecti, balls_[objecti].box);
    objects_[objecti] = object;
    surfaces_[objecti] = closedSurface();
    balls_[objecti] = ballOf(object);
    enter(objecti);
}


// ************************************************************************* //
