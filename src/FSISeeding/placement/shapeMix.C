// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeMix.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "Tuple2.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Is a shape NAME_1, NAME_2.. one of the classes or pieces of a shape NAME?
static bool isPiece(const word& shape, const word& name)
{
    const std::size_t n = name.size();
    return
        shape.size() > n + 1 && shape.compare(0, n, name) == 0
     && shape[n] == '_'
     && shape.find_first_not_of("0123456789", n + 1) == std::string::npos;
}


//- Names with their parts
static List<Tuple2<word, scalar>> readParts(const dictionary& dict)
{
    typedef List<Tuple2<word, scalar>> parts;
    if (dict.found("shape") == dict.found("shapes"))
    {
        FatalIOErrorInFunction(dict)
            << "Placement " << dict.name() << " needs either the entry 'shape'"
            << " or the entry 'shapes'" << exit(FatalIOError);
    }
    if (dict.found("shape"))
    {
        return parts(1, Tuple2<word, scalar>(getEntry<word>(dict, "shape"), 1));
    }
    const parts given(readEntry<parts>(dict, "shapes"));
    for (const Tuple2<word, scalar>& each : given)
    {
        if (!(each.second() > 0 && each.second() < GREAT))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'shapes' in dictionary " << dict.name() << ": the"
                << " part of shape " << each.first() << " is " << each.second()
                << " but must be > 0" << exit(FatalIOError);
        }
    }
    if (given.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shapes' in dictionary " << dict.name() << " is empty"
            << exit(FatalIOError);
    }
    return given;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::labelList Foam::fsi::shapeMix::named
(
    const word& name,
    const packing& space
)
{
    const label shapei = indexOf(space.shapeNames(), name);
    if (shapei >= 0)
    {
        return labelList(1, shapei);
    }
    DynamicList<label> shapes;
    forAll(space.shapeNames(), i)
    {
        if (isPiece(space.shapeNames()[i], name))
        {
            shapes.append(i);
        }
    }
    return labelList(shapes);
}


void Foam::fsi::shapeMix::fail
(
    const dictionary& dict,
    const word& key,
    const word& name,
    const packing& space
)
{
    FatalIOErrorInFunction(dict)
        << "Unknown shape '" << name << "' in entry '" << key
        << "' of placement " << dict.name() << nl
        << "Valid shapes are " << flatOutput(space.shapeNames())
        << exit(FatalIOError);
}


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
    scalar total = 0;
    for (const Tuple2<word, scalar>& each : readParts(dict))
    {
        const labelList shapes(named(each.first(), space));
        if (shapes.empty())
        {
            const word key(dict.found("shape") ? "shape" : "shapes");
            fail(dict, key, each.first(), space);
        }
        for (const label i : shapes)
        {
            const scalar number = each.second()/shapes.size();
            all.append(part{i, number, space.shape(i).volume()});
        }
        total += each.second();
    }
    std::stable_sort(all.begin(), all.end(), [](const part& a, const part& b)
    {
        return a.volume > b.volume;
    });
    for (const part& each : all)
    {
        shapes_.append(each.shape);
        parts_.append(each.number/total);
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
