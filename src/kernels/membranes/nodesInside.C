// SPDX-License-Identifier: GPL-3.0-or-later

#include "nodesInside.H"
#include "boxPairs.H"
#include "DynamicList.H"
#include "surfaceWinding.H"

#include <memory>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using Foam::fsi::surfaceFace;
using Foam::fsi::surfaceSet;

//- Triangles of an object in squares of y and z
class trianglesAlongX
{
    const surfaceSet& surfaces_;

    const boundBox box_;

    //- Number of squares in y and z
    label n_;

    List<DynamicList<label>> squares_;

    label squareAt(const scalar x, const direction d) const
    {
        const scalar span = box_.max()[d] - box_.min()[d];
        const label i = label(n_*(x - box_.min()[d])/max(span, VSMALL));
        return min(max(i, label(0)), n_ - 1);
    }

    //- Is a point on the left of the edge from node a to b in the plane of y
    //  and z? Both triangles of an edge get opposite answers
    bool isLeft(label a, label b, const point& p) const
    {
        const bool turned = a > b;
        if (turned)
        {
            std::swap(a, b);
        }
        const point& A = surfaces_.points()[a];
        const point& B = surfaces_.points()[b];
        const bool left =
            (B.y() - A.y())*(p.z() - A.z()) > (B.z() - A.z())*(p.y() - A.y());
        return left != turned;
    }

    //- Is a triangle farther along x than a point, on its ray?
    bool meetsRay(const surfaceFace& f, const point& p) const
    {
        const bool left = isLeft(f[0], f[1], p);
        if (isLeft(f[1], f[2], p) != left || isLeft(f[2], f[0], p) != left)
        {
            return false;
        }
        const point& A = surfaces_.points()[f[0]];
        const vector n
        (
            (surfaces_.points()[f[1]] - A) ^ (surfaces_.points()[f[2]] - A)
        );
        return mag(n.x()) > 0 && ((A - p) & n)/n.x() > 0;
    }

public:

    trianglesAlongX(const surfaceSet& surfaces, const label objecti)
    :
        surfaces_(surfaces),
        box_(surfaces.bounds(objecti))
    {
        const label start = surfaces.faceStart()[objecti];
        const label end = surfaces.faceStart()[objecti + 1];
        n_ = max(label(std::sqrt(scalar(end - start)/4)), label(1));
        squares_.setSize(n_*n_);
        for (label facei = start; facei < end; ++facei)
        {
            const surfaceFace& f = surfaces.faces()[facei];
            point low(surfaces.points()[f[0]]), high(low);
            for (const label nodei : f)
            {
                low = min(low, surfaces.points()[nodei]);
                high = max(high, surfaces.points()[nodei]);
            }
            const label lastJ = squareAt(high.y(), 1);
            const label lastK = squareAt(high.z(), 2);
            for (label k = squareAt(low.z(), 2); k <= lastK; ++k)
            {
                for (label j = squareAt(low.y(), 1); j <= lastJ; ++j)
                {
                    squares_[j + n_*k].append(facei);
                }
            }
        }
    }

    bool contains(const point& p) const
    {
        bool inside = false;
        if (box_.contains(p))
        {
            const label square = squareAt(p.y(), 1) + n_*squareAt(p.z(), 2);
            for (const label facei : squares_[square])
            {
                inside = inside != meetsRay(surfaces_.faces()[facei], p);
            }
        }
        return inside;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::insideCounts Foam::fsi::nodesInside
(
    const surfaceSet& surfaces,
    const vector& period
)
{
    List<boundBox> boxes(surfaces.size());
    boolList found(surfaces.points().size(), false);
    std::vector<std::unique_ptr<trianglesAlongX>> triangles(boxes.size());
    const auto inside = [&](const label objecti, const point& x)
    {
        // An outline has few segments
        if (surfaces.nDims() == 2)
        {
            return Foam::fsi::contains(surfaces, objecti, x);
        }
        if (!triangles[objecti])
        {
            triangles[objecti] =
                std::make_unique<trianglesAlongX>(surfaces, objecti);
        }
        return triangles[objecti]->contains(x);
    };
    const auto mark = [&](const label a, const label b, const vector& shift)
    {
        if (surfaces.hasWalls(a) && surfaces.hasWalls(b))
        {
            return;
        }
        const label end = surfaces.pointStart()[a + 1];
        for (label i = surfaces.pointStart()[a]; i < end; ++i)
        {
            found[i] = found[i] || inside(b, surfaces.points()[i] + shift);
        }
    };
    forAll(boxes, objecti)
    {
        boxes[objecti] = surfaces.bounds(objecti);
    }
    for (const boxPair& pair : boxPairs(boxes, period, surfaces.nDims()))
    {
        mark(pair.first, pair.second, pair.shift);
        mark(pair.second, pair.first, -pair.shift);
    }
    insideCounts counts;
    forAll(found, i)
    {
        const bool walls = surfaces.hasWalls(surfaces.pointObject()[i]);
        (walls ? counts.ofOthers : counts.ofMembranes) += found[i];
    }
    return counts;
}


// ************************************************************************* //
