// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeMix.H"
#include "shapeParts.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shapeMix::shapeMix(const dictionary& dict, const packing& space)
{
    struct part
    {
        label shape;
        scalar number;
        scalar volume;
    };
    DynamicList<part> all;
    const shapeParts given(dict, space.shapeNames());
    forAll(given.shapes, i)
    {
        const label shapei = given.shapes[i];
        const scalar volume = space.shape(shapei).volume();
        all.append(part{shapei, given.parts[i], volume});
    }
    std::stable_sort(all.begin(), all.end(), [](const part& a, const part& b)
    {
        return a.volume > b.volume;
    });
    for (const part& each : all)
    {
        shapes_.append(each.shape);
        parts_.append(each.number);
        volumes_.append(each.volume);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsi::shapeMix::names(const packing& space) const
{
    string all;
    for (const label i : shapes_)
    {
        all += (all.empty() ? "" : " ") + space.shapeNames()[i];
    }
    return all;
}


bool Foam::fsi::shapeMix::immersed(const packing& space) const
{
    return std::all_of(shapes_.begin(), shapes_.end(), [&](const label i)
    {
        return space.immersed(i);
    });
}


Foam::scalar Foam::fsi::shapeMix::meanVolume() const
{
    scalar sum = 0;
    forAll(parts_, i)
    {
        sum += parts_[i]*volumes_[i];
    }
    return sum;
}


Foam::labelList Foam::fsi::shapeMix::ofObjects(const label number) const
{
    // Whole numbers, then one more where the largest fractions are left
    labelList counts(shapes_.size());
    labelList order(shapes_.size());
    scalarList left(shapes_.size());
    label sum = 0;
    forAll(shapes_, i)
    {
        counts[i] = label(number*parts_[i]*(1 + SMALL));
        left[i] = std::round(1e9*(number*parts_[i] - counts[i]));
        order[i] = i;
        sum += counts[i];
    }
    std::stable_sort(order.begin(), order.end(), [&](label a, label b)
    {
        return left[a] > left[b];
    });
    for (label i = 0; sum < number; ++i, ++sum)
    {
        ++counts[order[i]];
    }
    labelList shapes(number);
    label next = 0;
    forAll(shapes_, i)
    {
        for (label j = 0; j < counts[i] && next < number; ++j)
        {
            shapes[next++] = shapes_[i];
        }
    }
    return shapes;
}


// ************************************************************************* //
