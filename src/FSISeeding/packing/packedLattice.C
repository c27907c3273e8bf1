// SPDX-License-Identifier: GPL-3.0-or-later

#include "packedLattice.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::packedLattice::closest
(
    const direction along,
    const UList<vector>& offsets,
    const scalar largest
) const
{
    const auto fits = [&](vector offset, const scalar distance)
    {
        offset[along] += distance;
        return !object_.closerThan
        (
            object_.moved(tensor::I, offset), gap_
        );
    };

    // From above, so that rows do not slip past each other
    const label nSteps = 500;
    scalar distance = largest;
    for (label i = nSteps; i > 0; --i)
    {
        const scalar shorter = largest*i/nSteps;
        bool all = true;
        for (const vector& offset : offsets)
        {
            all = all && fits(offset, shorter);
        }
        if (!all || !fits(Zero, 2*shorter))
        {
            break;
        }
        distance = shorter;
    }
    return distance;
}


Foam::vector Foam::fsi::packedLattice::pitch() const
{
    // A little more than the gap, against round-off
    const vector size = object_.bounds().span();
    const scalar gap = gap_*(1 + 1e-6) + 1e-9*mag(size);
    vector p(size + vector(gap, gap, gap));

    DynamicList<vector> offsets;
    if (type_ == STAGGERED)
    {
        offsets.append(vector(0.5*p.x(), 0, 0));
        offsets.append(vector(-0.5*p.x(), 0, 0));
        p.y() = closest(vector::Y, offsets, p.y());
    }
    if (type_ == RECTANGULAR || object_.nDims() == 2)
    {
        return p;
    }

    // Objects of the next layer, whose row lies between two of this one
    offsets.clear();
    for (const label layeri : {1, -1})
    {
        for (label rowi = -2; rowi <= 1; ++rowi)
        {
            const vector s(shift(rowi, 1));
            for (label i = -2; i <= 1; ++i)
            {
                const vector offset(i + s.x(), rowi + s.y(), 0);
                offsets.append(layeri*cmptMultiply(offset, p));
            }
        }
    }
    p.z() = closest(vector::Z, offsets, p.z());
    return p;
}


Foam::vector Foam::fsi::packedLattice::shift
(
    const label rowi,
    const label layeri
) const
{
    const label odd = layeri % 2;
    switch (type_)
    {
        case STAGGERED:
            return vector((rowi + odd) % 2 ? 0.5 : 0, odd/3.0, 0);

        case HOLLOWS:
            return odd*vector(0.5, 0.5, 0);

        default:
            return Zero;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::packedLattice::packedLattice
(
    const closedSurface& object,
    const scalar gap,
    const arrangement type
)
:
    object_(object),
    gap_(gap),
    type_(type),
    pitch_(pitch())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsi::packedLattice::arrangement>
Foam::fsi::packedLattice::arrangements(const direction nDims)
{
    return
        nDims == 2
      ? List<arrangement>({RECTANGULAR, STAGGERED})
      : List<arrangement>({RECTANGULAR, STAGGERED, HOLLOWS});
}


Foam::pointField Foam::fsi::packedLattice::sites
(
    const boundBox& container
) const
{
    const bool plane = object_.nDims() == 2;
    const vector& p = pitch_;

    // Centre of the first object
    const point start(container.min() - object_.bounds().min());
    const vector room(container.span() - object_.bounds().span());
    const scalar depth = plane ? 0 : room.z();

    DynamicList<point> found;
    for (label k = 0; k*p.z() <= depth; ++k)
    {
        for (label j = 0; (j + shift(j, k).y())*p.y() <= room.y(); ++j)
        {
            const vector s(shift(j, k));
            for (label i = 0; (i + s.x())*p.x() <= room.x(); ++i)
            {
                const vector place(i + s.x(), j + s.y(), k);
                found.append(start + cmptMultiply(place, p));
                if (plane)
                {
                    found.last().z() = 0;
                }
            }
        }
    }
    return pointField(std::move(found));
}


// ************************************************************************* //
