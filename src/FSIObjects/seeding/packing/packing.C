// SPDX-License-Identifier: GPL-3.0-or-later

#include "packing.H"
#include "IStringStream.H"
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

Foam::label Foam::fsi::packing::findHere
(
    const closedSurface& candidate,
    const scalar gap,
    const label except
) const
{
    const vector margin(gap, gap, gap);
    return grid_.find
    (
        boundBox
        (
            candidate.bounds().min() - margin,
            candidate.bounds().max() + margin
        ),
        [&](const label objecti)
        {
            return
                objecti != except
             && candidate.closerThan(surfaces_[objecti], gap);
        }
    );
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
    const pointField& places
)
:
    domain_(domain),
    spacing_(spacing),
    shapeNames_(shapeNames),
    shapes_(shapes),
    period_(period),
    attached_(attached),
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
    return shapes_[object.shape].moved(object.rotation, object.centre);
}


Foam::label Foam::fsi::packing::findConflict
(
    const closedSurface& candidate,
    const scalar gap,
    const label except
) const
{
    for (const vector& shift : shifts_)
    {
        const boundBox box
        (
            candidate.bounds().min() + shift,
            candidate.bounds().max() + shift
        );
        label found = -1;
        if (shift == vector::zero)
        {
            found = findHere(candidate, gap, except);
        }
        else if (closedSurface::near(box, occupied_, gap, nDims()))
        {
            found = findHere(candidate.moved(tensor::I, shift), gap, except);
        }
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
    scalar least = limit;
    for (const vector& shift : shifts_)
    {
        const closedSurface image(candidate.moved(tensor::I, shift));
        least = image.distance(surfaces_[objecti], least);
    }
    return least;
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
    extend(occupied_, surfaces_.last().bounds());
    grid_.enter(size() - 1, surfaces_.last().bounds());
    return size() - 1;
}


void Foam::fsi::packing::move
(
    const label objecti,
    const point& centre,
    const tensor& rotation,
    const closedSurface& moved
)
{
    grid_.takeOut(objecti, surfaces_[objecti].bounds());
    objects_[objecti].centre = centre;
    objects_[objecti].rotation = rotation;
    surfaces_[objecti] = moved;
    extend(occupied_, moved.bounds());
    grid_.enter(objecti, moved.bounds());
}


// ************************************************************************* //
