// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceThickness.H"
#include "boundBox.H"
#include "surfaceTools.H"
#include "triangleTree.H"
#include "unitConversion.H"

#include <map>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace surfaceThickness
{

//- Turn from which on a place is a corner [rad]
static const scalar cornerAngle = degToRad(15.0);

//- Angle up to which a face is across from the edge of a notch [rad]: it is 45
//  degrees inside a right angle, and near 90 where the edge ends at a side
static const scalar notchAngle = degToRad(60.0);

//- Number of places below which the thickness is measured, at least
static const label nSamples = 10000;

using namespace triangleTree;


//- Twice the area, along the outward normal [m2]
static vector normal(const shapeMesh& surface, const label facei)
{
    const surfaceFace& f = surface.faces[facei];
    const point& a = surface.points[f[0]];
    return (surface.points[f[1]] - a)^(surface.points[f[2]] - a);
}


namespace
{

//- Search in a surface's faces
class thicknessSearch
{
    const shapeMesh& surface_;
    triangleList triangles_;
    searchTree tree_;

public:

    explicit thicknessSearch(const shapeMesh& surface)
    :
        surface_(surface),
        triangles_(trianglesOf(surface))
    {
        tree_.rebuild(triangles_.begin(), triangles_.end());
    }

    //- Distance from a place on some faces to the next face along a direction
    //  [m]; GREAT if there is none, or if it does not face the place: to within
    //  cornerAngle, notchAngle if there are two faces
    scalar across
    (
        const point& from,
        const vector& along,
        const label facei,
        const label otherFacei = -1
    ) const;
};


scalar thicknessSearch::across
(
    const point& from,
    const vector& along,
    const label facei,
    const label otherFacei
) const
{
    const auto met = tree_.first_intersected_primitive
    (
        kernel::Ray_3
        (
            toCgal(from), kernel::Vector_3(along.x(), along.y(), along.z())
        ),
        [&](const triangleList::const_iterator& other)
        {
            const label found = other - triangles_.begin();
            return found == facei || found == otherFacei;
        }
    );
    if (!met)
    {
        return GREAT;
    }
    const label metFacei = *met - triangles_.begin();
    const vector n(normal(surface_, metFacei));
    const scalar slope = along & n;
    const scalar angle = otherFacei >= 0 ? notchAngle : cornerAngle;
    const bool faces = slope > std::cos(angle)*mag(along)*mag(n);
    const point& corner = surface_.points[surface_.faces[metFacei][0]];
    return faces ? mag(along)*mag(((corner - from) & n)/slope) : GREAT;
}

} // End anonymous namespace


//- Smallest thickness below the middles of a face's parts [m]
static scalar belowFace
(
    const shapeMesh& surface,
    const thicknessSearch& search,
    const label facei,
    const label nParts
)
{
    const surfaceFace& f = surface.faces[facei];
    const point& a = surface.points[f[0]];
    const vector b = (surface.points[f[1]] - a)/nParts;
    const vector c = (surface.points[f[2]] - a)/nParts;
    const vector inward(-normal(surface, facei));

    scalar result = GREAT;
    for (label i = 0; i < nParts; ++i)
    {
        for (label j = 0; j + i < nParts; ++j)
        {
            // A part, and the one turned round beside it
            const point middle = a + (i + 1.0/3)*b + (j + 1.0/3)*c;
            result = min(result, search.across(middle, inward, facei));
            if (i + j + 1 < nParts)
            {
                const point beside = middle + (b + c)/3;
                result = min(result, search.across(beside, inward, facei));
            }
        }
    }
    return result;
}


//- Smallest thickness below the edges of notches [m]
static scalar belowNotches
(
    const shapeMesh& surface,
    const thicknessSearch& search,
    const scalar spacing
)
{
    std::map<std::pair<label, label>, label> faceOfSide;
    forAll(surface.faces, facei)
    {
        const surfaceFace& f = surface.faces[facei];
        for (label i = 0; i < 3; ++i)
        {
            faceOfSide[{f[i], f[(i + 1) % 3]}] = facei;
        }
    }

    scalar result = GREAT;
    for (const auto& side : faceOfSide)
    {
        const auto other =
            faceOfSide.find({side.first.second, side.first.first});
        if (other == faceOfSide.end() || other->second < side.second)
        {
            continue;
        }
        const point& a = surface.points[side.first.first];
        const vector s = surface.points[side.first.second] - a;
        const vector n = normalised(normal(surface, side.second));
        const vector m = normalised(normal(surface, other->second));
        if (std::atan2(s & (n^m), mag(s)*(n & m)) > -cornerAngle)
        {
            continue;
        }
        const label nParts = 1 + label(mag(s)/spacing);
        for (label i = 0; i < nParts; ++i)
        {
            result = min
            (
                result,
                search.across
                (
                    a + (i + 0.5)/nParts*s,
                    -(n + m),
                    side.second,
                    other->second
                )
            );
        }
    }
    return result;
}

} // End namespace surfaceThickness
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::surfaceThickness::smallest(const shapeMesh& surface)
{
    const scalar part =
        surfaceTools::area(surface.points, surface.faces)/nSamples;
    const thicknessSearch search(surface);

    scalar result = belowNotches(surface, search, std::sqrt(part));
    forAll(surface.faces, facei)
    {
        const scalar area = 0.5*mag(normal(surface, facei));
        const label nParts = 1 + label(std::sqrt(area/part));
        result = min(result, belowFace(surface, search, facei, nParts));
    }
    return
        result < GREAT
      ? result
      : cmptMin(boundBox(surface.points, false).span());
}


// ************************************************************************* //
