// SPDX-License-Identifier: GPL-3.0-or-later

#include "insideScan.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- First sample of a block's row behind x, from 0 to nx
static label firstBehind(const cartesianBlock& block, const scalar x)
{
    const label begin = block.start().x();
    const label end = begin + block.n().x();

    label i = begin + block.nUpTo(x, 0);
    while (i > begin && block.latticePosition(i - 1, 0) > x)
    {
        --i;
    }
    while (i < end && block.latticePosition(i, 0) <= x)
    {
        ++i;
    }
    return i - begin;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::insideScan::addSegment
(
    const cartesianBlock& block,
    const point& a,
    const point& b,
    const label k
)
{
    // One row more at either end, for round-off
    const label first = max(block.nUpTo(min(a.y(), b.y()), 1) - 1, 0);
    const label end =
        min(block.nUpTo(max(a.y(), b.y()), 1) + 1, block.n().y());

    for (label j = first; j < end; ++j)
    {
        const scalar y = block.latticePosition(block.start().y() + j, 1);
        if ((a.y() <= y) == (b.y() <= y))
        {
            continue;
        }
        const scalar x =
            a.x() + (y - a.y())/(b.y() - a.y())*(b.x() - a.x());

        const int64_t row = j + block.n().y()*k;
        crossings_.append(row*(block.n().x() + 1) + firstBehind(block, x));
    }
}


void Foam::fsi::insideScan::addTriangle
(
    const cartesianBlock& block,
    const pointField& points,
    const surfaceFace& f
)
{
    const FixedList<scalar, 3> z
    ({
        points[f[0]].z(), points[f[1]].z(), points[f[2]].z()
    });
    label first, last;
    block.range
    (
        min(z[0], min(z[1], z[2])),
        max(z[0], max(z[1], z[2])),
        2,
        first,
        last
    );

    for (label k = first; k <= last; ++k)
    {
        const scalar plane = block.latticePosition(k, 2);
        FixedList<point, 2> cut;
        label nCuts = 0;
        for (label i = 0; i < 3; ++i)
        {
            const label j = (i + 1) % 3;
            if ((z[i] <= plane) == (z[j] <= plane))
            {
                continue;
            }
            const point& a = points[min(f[i], f[j])];
            const point& b = points[max(f[i], f[j])];
            cut[nCuts++] = a + (plane - a.z())/(b.z() - a.z())*(b - a);
        }
        if (nCuts == 2)
        {
            addSegment(block, cut[0], cut[1], k - block.start().z());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::insideScan::mark
(
    const surfaceSet& surfaces,
    const label objecti,
    const cartesianBlock& block,
    labelList& object
)
{
    const pointField& points = surfaces.points();
    const labelList& faceStart = surfaces.faceStart();

    crossings_.clear();
    for (label i = faceStart[objecti]; i < faceStart[objecti + 1]; ++i)
    {
        const surfaceFace& f = surfaces.faces()[i];
        if (surfaces.nDims() == 2)
        {
            addSegment(block, points[f[0]], points[f[1]], 0);
        }
        else
        {
            addTriangle(block, points, f);
        }
    }

    std::sort(crossings_.begin(), crossings_.end());

    const label nx = block.n().x();
    for (label c = 0; c < crossings_.size(); c += 2)
    {
        const int64_t row = crossings_[c]/(nx + 1);
        if
        (
            c + 1 == crossings_.size()
         || crossings_[c + 1]/(nx + 1) != row
        )
        {
            FatalErrorInFunction
                << "The surface of object " << objecti << " is not closed"
                << exit(FatalError);
        }

        const label begin = row*nx + crossings_[c] % (nx + 1);
        const label end = row*nx + crossings_[c + 1] % (nx + 1);
        std::fill(object.begin() + begin, object.begin() + end, objecti);
    }
}


// ************************************************************************* //
