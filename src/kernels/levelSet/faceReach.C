// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceReach.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Wider than the width, for round-off
static const scalar wider = 1.001;

//- A slab that is steeper against x limits no row: the bounds do
static const scalar smallestSlope = 1e-3;

//- Sine of the angle between unit vectors, 1 beyond a right angle
static scalar turn(const vector& a, const vector& b)
{
    const scalar cosine = a & b;
    return cosine > 0 ? sqrt(max(1 - sqr(cosine), 0.0)) : 1;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::faceReach::add
(
    const vector& normal,
    const point& a,
    const scalar lower,
    const scalar upper
)
{
    if (mag(normal.x()) > smallestSlope)
    {
        const scalar first = lower/normal.x();
        const scalar second = upper/normal.x();
        slabs_[nSlabs_++] =
        {
            a,
            min(first, second),
            max(first, second),
            -normal.y()/normal.x(),
            -normal.z()/normal.x()
        };
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::faceReach::faceReach
(
    const point& a,
    const point& b,
    const vector& beforeA,
    const vector& afterB,
    const scalar width
)
:
    nSlabs_(0)
{
    const scalar w = wider*width;
    const vector edge(b - a);
    const scalar length = mag(edge);
    const vector along(edge/max(length, VSMALL));
    const vector normal(along.y(), -along.x(), 0);
    const scalar lower = -w*turn(beforeA, along) - (w - width);
    const scalar upper = length + w*turn(along, afterB) + (w - width);

    // The corners of a rectangle; all about a segment without length
    const bool degenerate = !(length > VSMALL);
    const vector ahead(degenerate ? vector(w, 0, 0) : upper*along);
    const vector behind(degenerate ? vector(-w, 0, 0) : lower*along);
    const vector aside(degenerate ? vector(0, w, 0) : w*normal);
    const vector half(cmptMag(0.5*(ahead - behind)) + cmptMag(aside));
    const point middle(a + 0.5*(ahead + behind));
    bounds_ = boundBox(middle - half, middle + half);

    if (!degenerate)
    {
        add(normal, a, -w, w);
        add(along, a, lower, upper);
    }
}


Foam::fsi::faceReach::faceReach
(
    const boundBox& bounds,
    const point& a,
    const vector& normal,
    const scalar width
)
:
    bounds_(bounds),
    nSlabs_(0)
{
    const scalar w = wider*width;
    bounds_.min() -= vector::uniform(w);
    bounds_.max() += vector::uniform(w);
    add(normal, a, -w, w);
}


// ************************************************************************* //
