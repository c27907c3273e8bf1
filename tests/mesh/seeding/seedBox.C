// SPDX-License-Identifier: GPL-3.0-or-later

#include "seedBox.H"
#include "../population/someObjects.H"
#include "placement.H"
#include "unitConversion.H"

using namespace Foam;
using Foam::fsi::outline;
using Foam::fsi::packing;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Outline of an ellipse
outline ellipse(const scalar a, const scalar b)
{
    const label n = 40;
    pointField points(n);
    forAll(points, i)
    {
        const scalar angle = degToRad(i*360.0/n);
        points[i] = point(a*Foam::cos(angle), b*Foam::sin(angle), 0);
    }
    return outline(points);
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

tensor seedBox::rotation(const scalar degrees)
{
    const scalar c = Foam::cos(degToRad(degrees));
    const scalar s = Foam::sin(degToRad(degrees));
    return tensor(c, -s, 0, s, c, 0, 0, 0, 1);
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


std::string seedBox::errorOf(const std::string& text, const vector& period)
{
    packing space(emptyBox(period));
    return someObjects::errorText([&]() { place(space, text); });
}


// ************************************************************************* //
