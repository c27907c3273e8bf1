// SPDX-License-Identifier: GPL-3.0-or-later

#include "packing.H"
#include "StringStream.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void Foam::fsi::packing::forCells
(
    const boundBox& box,
    const Function& function
) const
{
    // What is outside the domain is kept in the cells along its sides
    const auto cell = [&](const scalar distance, const label n)
    {
        return label(min(max(distance/cellSize_, 0.0), n - 0.5));
    };
    const label iEnd = cell(box.max().x() - domain_.min().x(), nx_);
    const label jEnd = cell(box.max().y() - domain_.min().y(), ny_);

    for (label j = cell(box.min().y() - domain_.min().y(), ny_); j <= jEnd; ++j)
    {
        label i = cell(box.min().x() - domain_.min().x(), nx_);
        for (; i <= iEnd; ++i)
        {
            if (function(i + nx_*j))
            {
                return;
            }
        }
    }
}


Foam::label Foam::fsi::packing::findHere
(
    const outline& candidate,
    const scalar gap,
    const label except
) const
{
    const vector margin(gap, gap, gap);
    const boundBox box
    (
        candidate.bounds().min() - margin,
        candidate.bounds().max() + margin
    );

    ++search_;
    label found = -1;
    forCells
    (
        box,
        [&](const label celli)
        {
            for (const label objecti : cells_[celli])
            {
                if (objecti == except || lastSearch_[objecti] == search_)
                {
                    continue;
                }
                lastSearch_[objecti] = search_;
                if (candidate.closerThan(outlines_[objecti], gap))
                {
                    found = objecti;
                    return true;
                }
            }
            return false;
        }
    );
    return found;
}


void Foam::fsi::packing::enter(const label objecti)
{
    occupied_.add(outlines_[objecti].bounds());
    forCells
    (
        outlines_[objecti].bounds(),
        [&](const label celli)
        {
            cells_[celli].append(objecti);
            return false;
        }
    );
}


void Foam::fsi::packing::takeOut(const label objecti)
{
    forCells
    (
        outlines_[objecti].bounds(),
        [&](const label celli)
        {
            DynamicList<label>& cell = cells_[celli];
            std::swap(cell[cell.find(objecti)], cell.last());
            cell.remove();
            return false;
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::packing::packing
(
    const boundBox& domain,
    const scalar spacing,
    const wordList& shapeNames,
    const List<outline>& shapes,
    const vector& period,
    const boolList& attached
)
:
    domain_(domain),
    spacing_(spacing),
    shapeNames_(shapeNames),
    shapes_(shapes),
    period_(period),
    attached_(attached),
    shifts_(1, Zero),
    cellSize_(GREAT),
    search_(0)
{
    // Cells about as large as the smallest shape, but not too many of them
    for (const outline& s : shapes_)
    {
        cellSize_ = min(cellSize_, max(s.bounds().span().x(), 3*spacing_));
    }
    const scalar lx = domain_.span().x(), ly = domain_.span().y();
    cellSize_ = min(max(cellSize_, sqrt(lx*ly/1e6)), max(lx, ly));
    nx_ = label(lx/cellSize_) + 1;
    ny_ = label(ly/cellSize_) + 1;
    cells_.resize(nx_*ny_);

    for (direction d = 0; d < 2; ++d)
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


Foam::fsi::outline Foam::fsi::packing::placedOutline
(
    const placedObject& object
) const
{
    return shapes_[object.shape].moved(object.rotation, object.centre);
}


Foam::label Foam::fsi::packing::findConflict
(
    const outline& candidate,
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
        else if (outline::near(box, occupied_, gap))
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
    const outline& candidate,
    const label objecti
) const
{
    scalar least = GREAT;
    for (const vector& shift : shifts_)
    {
        const outline image(candidate.moved(tensor::I, shift));
        least = min(least, image.distance(outlines_[objecti]));
    }
    return least;
}


bool Foam::fsi::packing::inDomain
(
    const placedObject& object,
    const outline& candidate,
    const scalar gap
) const
{
    const point& centre = object.centre;
    boundBox box(domain_);
    for (direction d = 0; d < 2; ++d)
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
    return inside(candidate, box, gap);
}


bool Foam::fsi::packing::inside
(
    const outline& candidate,
    const boundBox& box,
    const scalar gap
)
{
    const vector low(candidate.bounds().min() - box.min());
    const vector high(box.max() - candidate.bounds().max());
    return min(min(low.x(), low.y()), min(high.x(), high.y())) >= gap;
}


Foam::label Foam::fsi::packing::insert(const placedObject& object)
{
    objects_.append(object);
    outlines_.append(placedOutline(object));
    lastSearch_.append(0);
    enter(size() - 1);
    return size() - 1;
}


void Foam::fsi::packing::move
(
    const label objecti,
    const point& centre,
    const tensor& rotation,
    const outline& moved
)
{
    takeOut(objecti);
    objects_[objecti].centre = centre;
    objects_[objecti].rotation = rotation;
    outlines_[objecti] = moved;
    enter(objecti);
}


// ************************************************************************* //
