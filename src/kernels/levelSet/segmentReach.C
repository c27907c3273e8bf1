// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentReach.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Wider than the width, for round-off
static const scalar wider = 1.001;

//- A slab that is steeper against x limits no row: the bounds do
static const scalar smallestSlope = 1e-3;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::segmentReach::set
(
    slab& s,
    const vector& normal,
    const point& a,
    const scalar lower,
    const scalar upper
)
{
    if (mag(normal.x()) > smallestSlope)
    {
        const scalar perNormal = 1/normal.x();
        s.origin = a;
        s.lower = min(lower*perNormal, upper*perNormal);
        s.upper = max(lower*perNormal, upper*perNormal);
        s.slopeY = -normal.y()*perNormal;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::segmentReach::segmentReach
(
    const point& a,
    const vector& along,
    const scalar length,
    const scalar turnA,
    const scalar turnB,
    const scalar width
)
{
    const scalar w = wider*width;
    const vector normal(along.y(), -along.x(), 0);
    const scalar lower = -w*turnA - (w - width);
    const scalar upper = length + w*turnB + (w - width);

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
        set(slabs_[0], normal, a, -w, w);
        set(slabs_[1], along, a, lower, upper);
    }
}


// ************************************************************************* //
