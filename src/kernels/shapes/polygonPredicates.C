// SPDX-License-Identifier: GPL-3.0-or-later

#include "polygonPredicates.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace polygonPredicates
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef std::vector<kernel::Point_2> corners;


static corners cornersOf(const pointField& polygon)
{
    corners points;
    points.reserve(polygon.size());
    for (const point& p : polygon)
    {
        points.emplace_back(p.x(), p.y());
    }
    return points;
}


static CGAL::Bbox_2 boxOf(const corners& points)
{
    return CGAL::bbox_2(points.begin(), points.end());
}


//- Sides of a polygon that meet a box
static std::vector<kernel::Segment_2> sidesIn
(
    const corners& points,
    const CGAL::Bbox_2& box
)
{
    std::vector<kernel::Segment_2> sides;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const kernel::Segment_2 side(points[i], points[(i + 1)%points.size()]);
        if (CGAL::do_overlap(side.bbox(), box))
        {
            sides.push_back(side);
        }
    }
    return sides;
}


//- Is a point inside a polygon or on it
static bool holds(const corners& polygon, const kernel::Point_2& p)
{
    return
        CGAL::bounded_side_2(polygon.begin(), polygon.end(), p, kernel())
     != CGAL::ON_UNBOUNDED_SIDE;
}


static bool overlap(const corners& a, const corners& b)
{
    const CGAL::Bbox_2 boxA = boxOf(a), boxB = boxOf(b);
    if (!CGAL::do_overlap(boxA, boxB))
    {
        return false;
    }
    const auto sidesB = sidesIn(b, boxA);
    for (const kernel::Segment_2& s : sidesIn(a, boxB))
    {
        for (const kernel::Segment_2& t : sidesB)
        {
            if
            (
                CGAL::do_overlap(s.bbox(), t.bbox())
             && CGAL::do_intersect(s, t)
            )
            {
                return true;
            }
        }
    }
    return holds(a, b.front()) || holds(b, a.front());
}

} // End namespace polygonPredicates
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::polygonPredicates::isSimple(const pointField& polygon)
{
    const corners points = cornersOf(polygon);
    return CGAL::is_simple_2(points.begin(), points.end(), kernel());
}


bool Foam::fsi::polygonPredicates::overlap
(
    const pointField& a,
    const pointField& b
)
{
    return overlap(cornersOf(a), cornersOf(b));
}


// ************************************************************************* //
