// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxPairs.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "labelVector.H"
#include "openfoamVersion.H"
#include "nullBox.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A box moved by whole periods
struct movedBox
{
    label index;

    boundBox box;

    vector shift;

    //- Is it the one in the first cell of the periods
    bool home;
};


static bool meet(const boundBox& a, const boundBox& b, const direction nDims)
{
    for (direction d = 0; d < nDims; ++d)
    {
        if (a.min()[d] > b.max()[d] || b.min()[d] > a.max()[d])
        {
            return false;
        }
    }
    return true;
}


static boundBox moved(const boundBox& box, const vector& shift)
{
    return boundBox(box.min() + shift, box.max() + shift);
}


//- Shifts that bring the centres of boxes into the first cell of the periods
static vectorField homeShifts
(
    const UList<boundBox>& boxes,
    const vector& period,
    const direction nDims
)
{
    vectorField shifts(boxes.size(), Zero);
    forAll(boxes, i)
    {
        for (direction d = 0; d < nDims; ++d)
        {
            if (period[d] > 0)
            {
                shifts[i][d] =
                    -period[d]*std::floor(centreOf(boxes[i])[d]/period[d]);
            }
        }
    }
    return shifts;
}


//- Does a pair count: is neither longer than a period along which one is moved
//  against the other?
static bool counts
(
    const UList<boundBox>& boxes,
    const movedBox& a,
    const movedBox& b,
    const vector& period
)
{
    for (direction d = 0; d < 3; ++d)
    {
        const scalar longest =
            max(boxes[a.index].span()[d], boxes[b.index].span()[d]);
        const scalar moved = mag(a.shift[d] - b.shift[d]);
        if (period[d] > 0 && longest > period[d] && moved > 0.5*period[d])
        {
            return false;
        }
    }
    return true;
}


//- The boxes in the first cell of the periods, and of their images those that
//  can meet one of them
static DynamicList<movedBox> imagesOf
(
    const UList<boundBox>& boxes,
    const vector& period,
    const direction nDims
)
{
    const vectorField homes(homeShifts(boxes, period, nDims));
    boundBox all(nullBox());
    labelVector n(0, 0, 0);
    forAll(boxes, i)
    {
        extend(all, moved(boxes[i], homes[i]));
        for (direction d = 0; d < nDims; ++d)
        {
            if (period[d] > 0)
            {
                const label own = label(boxes[i].span()[d]/period[d]);
                n[d] = max(n[d], 1 + own);
            }
        }
    }

    DynamicList<movedBox> images(boxes.size());
    forAll(boxes, i)
    {
        labelVector k;
        for (k.x() = -n.x(); k.x() <= n.x(); ++k.x())
        {
            for (k.y() = -n.y(); k.y() <= n.y(); ++k.y())
            {
                for (k.z() = -n.z(); k.z() <= n.z(); ++k.z())
                {
                    const vector shift
                    (
                        homes[i]
                      + vector
                        (
                            k.x()*period.x(), k.y()*period.y(), k.z()*period.z()
                        )
                    );
                    const boundBox box(moved(boxes[i], shift));
                    if (meet(box, all, nDims))
                    {
                        const bool home = k == labelVector::zero;
                        images.append(movedBox{i, box, shift, home});
                    }
                }
            }
        }
    }
    return images;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsi::boxPair> Foam::fsi::boxPairs
(
    const UList<boundBox>& boxes,
    const vector& period,
    const direction nDims
)
{
    DynamicList<movedBox> images(imagesOf(boxes, period, nDims));
    std::sort
    (
        images.begin(), images.end(),
        [](const movedBox& a, const movedBox& b)
        {
            return a.box.min().x() < b.box.min().x();
        }
    );

    DynamicList<boxPair> found;
    forAll(images, i)
    {
        const movedBox& a = images[i];
        for (label j = i + 1; j < images.size(); ++j)
        {
            const movedBox& b = images[j];
            if (b.box.min().x() > a.box.max().x())
            {
                break;
            }

            // The image of the first one meets the second one at home
            const movedBox& first = a.index < b.index ? a : b;
            const movedBox& second = a.index < b.index ? b : a;
            if
            (
                a.index != b.index && second.home
             && meet(a.box, b.box, nDims)
             && counts(boxes, a, b, period)
            )
            {
                found.append
                (
                    boxPair
                    {
                        first.index, second.index, first.shift - second.shift
                    }
                );
            }
        }
    }
    return List<boxPair>(std::move(found));
}


// ************************************************************************* //
