// SPDX-License-Identifier: GPL-3.0-or-later

#include "cylinder.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cylinder, 0);
    addToRunTimeSelectionTable(shape, cylinder, solid);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The entries of a rectangle through the axis
static dictionary sectionOf(const dictionary& dict)
{
    checkKeys(dict, {"type", "radius", "length", "edgeRadius"});
    dictionary section(dict);
    section.remove("radius");
    section.set("width", 2*readPositive(dict, "radius"));
    return section;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cylinder::cylinder(const dictionary& dict)
:
    section_(sectionOf(dict))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::cylinder::surface() const
{
    // Rings of m points from the end at +x to that at -x, between two points on
    // the axis
    const label m = 120;
    const scalar end = 0.5*section_.length();
    DynamicList<point> points;
    DynamicList<surfaceFace> faces;
    points.append(point(end, 0, 0));
    label last = -1;
    for (const point& p : section_.curve())
    {
        if (p.y() < 1e-6*section_.width())
        {
            continue;
        }
        const label first = points.size();
        for (label j = 0; j < m; ++j)
        {
            const scalar phi = constant::mathematical::twoPi*j/m;
            points.append
            (
                point(p.x(), p.y()*std::cos(phi), p.y()*std::sin(phi))
            );
            const label next = (j + 1) % m;
            if (last < 0)
            {
                faces.append(surfaceFace({0, first + j, first + next}));
                continue;
            }
            faces.append(surfaceFace({last + j, first + j, last + next}));
            faces.append(surfaceFace({last + next, first + j, first + next}));
        }
        last = first;
    }
    for (label j = 0; j < m; ++j)
    {
        faces.append
        (
            surfaceFace({last + j, points.size(), last + (j + 1) % m})
        );
    }
    points.append(point(-end, 0, 0));

    shapeMesh result;
    result.points = points;
    result.faces = faces;
    result.nBoundary = points.size();
    return result;
}


Foam::scalar Foam::fsi::cylinder::volume() const
{
    const scalar L = section_.length(), r = section_.edgeRadius();
    const scalar a = 0.5*section_.width() - r;
    const scalar pi = constant::mathematical::pi;
    return
        pi*sqr(a)*L
      + 4*pi
       *((0.5*L - r)*(a*r + 0.5*sqr(r)) + 0.25*pi*a*sqr(r) + pow3(r)/3);
}


Foam::scalar Foam::fsi::cylinder::cornerAngle() const
{
    return
        section_.edgeRadius() > 0
      ? solidShape::cornerAngle()
      : edgeAngle();
}


// ************************************************************************* //
