// SPDX-License-Identifier: GPL-3.0-or-later

#include "reachBoxes.H"
#include "DynamicList.H"
#include "latticeRanks.H"
#include "scalarList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Append a box to numbers
static void append(const boundBox& box, DynamicList<scalar>& numbers)
{
    for (direction d = 0; d < 3; ++d)
    {
        numbers.append(box.min()[d]);
        numbers.append(box.max()[d]);
    }
}


//- The box that starts at a number
static boundBox boxAt(const scalarList& numbers, const label start)
{
    boundBox box;
    for (direction d = 0; d < 3; ++d)
    {
        box.min()[d] = numbers[start + 2*d];
        box.max()[d] = numbers[start + 2*d + 1];
    }
    return box;
}


//- The smallest box around two
static boundBox around(const boundBox& a, const boundBox& b)
{
    return boundBox(min(a.min(), b.min()), max(a.max(), b.max()));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::reachBoxes::meets
(
    const boundBox& box,
    const boundBox& other
) const
{
    for (direction d = 0; d < 3; ++d)
    {
        bool any = false;
        for (label n = -1; n <= 1; ++n)
        {
            const scalar shift = n*period_[d];
            any =
                any
             || (
                    box.min()[d] + shift <= other.max()[d]
                 && box.max()[d] + shift >= other.min()[d]
                );
        }
        if (!any)
        {
            return false;
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::reachBoxes::find
(
    const UList<boundBox>& boxes,
    boolList& partner,
    labelListList& needed
) const
{
    boundBox own(point::max, point::min);
    for (const boundBox& box : boxes)
    {
        own = around(own, box);
    }
    boundBox near(around(own, cells_));
    const vector margin(vector::uniform(distance_));
    near = boundBox(near.min() - margin, near.max() + margin);
    DynamicList<scalar> numbers;
    append(own, numbers);
    append(near, numbers);
    const List<scalarList> ofRanks(gatherOverRanks(scalarList(numbers)));
    forAll(ofRanks, ranki)
    {
        const boundBox theirs(boxAt(ofRanks[ranki], 6));
        partner[ranki] =
            ranki != rankIn()
         && (meets(own, theirs) || meets(boxAt(ofRanks[ranki], 0), near));
        DynamicList<label> objects;
        for (label i = 0; i < boxes.size() && partner[ranki]; ++i)
        {
            if (meets(boxes[i], theirs))
            {
                objects.append(i);
            }
        }
        needed[ranki] = objects;
    }
}


// ************************************************************************* //
