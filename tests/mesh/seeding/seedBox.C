// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"
#include "population/someObjects.H"
#include "../../unit/samples/surfaceSamples.H"
#include "placement.H"
#include "unitConversion.H"

using namespace Foam;
using Foam::fsi::closedSurface;
using Foam::fsi::packing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Outline of an ellipse
closedSurface ellipse(const scalar a, const scalar b)
{
    const label n = 40;
    pointField points(n);
    forAll(points, i)
    {
        const scalar angle = degToRad(i*360.0/n);
        points[i] = point(a*Foam::cos(angle), b*Foam::sin(angle), 0);
    }
    return seedBox::outline(points);
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

tensor seedBox::rotation(const scalar degrees)
{
    const scalar c = Foam::cos(degToRad(degrees));
    const scalar s = Foam::sin(degToRad(degrees));
    return tensor(c, -s, 0, s, c, 0, 0, 0, 1);
}


closedSurface seedBox::outline(const pointField& nodes)
{
    List<fsi::surfaceFace> segments(nodes.size());
    forAll(segments, i)
    {
        segments[i][0] = i;
        segments[i][1] = nodes.fcIndex(i);
        segments[i][2] = -1;
    }
    return closedSurface(nodes, segments);
}


closedSurface seedBox::ellipsoid(const vector& axes, const label nCuts)
{
    fsi::surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, nCuts);
    pointField points(surfaces.points());
    for (point& p : points)
    {
        p = cmptMultiply(p, axes);
    }
    return closedSurface(points, surfaces.faces());
}


packing seedBox::emptyCube(const vector& period)
{
    return packing
    (
        boundBox(point(0, 0, 0), point(1, 1, 1)), 0.02,
        {"sphere", "cell"},
        {
            ellipsoid({0.1, 0.1, 0.1}, 3), ellipsoid({0.12, 0.12, 0.05}, 3)
        },
        period
    );
}


packing seedBox::emptyBox(const vector& period)
{
    return packing
    (
        boundBox(point(0, 0, 0), point(2, 1, 0.01)), 0.01,
        {"disc", "cell"}, {ellipse(0.05, 0.05), ellipse(0.08, 0.025)},
        period
    );
}


void seedBox::place(packing& space, const std::string& text)
{
    dictionary dict(someObjects::dict(text));
    dict.name() = "seedObjectsDict.placements.a";
    fsi::placement::New("a", dict, space)->place(space);
}


void seedBox::expectPieces
(
    const std::string& text,
    const std::vector<std::string>& pieces
)
{
    for (const std::string& piece : pieces)
    {
        EXPECT_NE(text.find(piece), std::string::npos) << piece << ": " << text;
    }
}


std::string seedBox::errorIn(packing space, const std::string& text)
{
    return someObjects::errorText([&]() { place(space, text); });
}


std::string seedBox::errorOf(const std::string& text, const vector& period)
{
    return errorIn(emptyBox(period), text);
}


// ************************************************************************* //
