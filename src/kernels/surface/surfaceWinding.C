// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceWinding.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- 1 if an edge crosses the ray from the origin along x upwards, -1 downwards
static scalar crossing(const vector& a, const vector& b)
{
    const bool up = a.y() <= 0 && b.y() > 0;
    const bool down = a.y() > 0 && b.y() <= 0;
    if (!up && !down)
    {
        return 0;
    }
    const scalar left = a.x()*b.y() - b.x()*a.y();
    return up ? (left > 0 ? 1 : 0) : (left < 0 ? -1 : 0);
}


//- Solid angle of a triangle seen from the origin
static scalar solidAngle(const vector& a, const vector& b, const vector& c)
{
    const scalar la = mag(a), lb = mag(b), lc = mag(c);
    return 2*atan2
    (
        a & (b ^ c),
        la*lb*lc + (a & b)*lc + (b & c)*la + (c & a)*lb
    );
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::windingNumber
(
    const UList<point>& x,
    const UList<surfaceFace>& faces,
    const point& p
)
{
    const bool plane = faces.size() && faces[0][2] < 0;

    scalar sum = 0;
    for (const surfaceFace& f : faces)
    {
        const vector a(x[f[0]] - p);
        const vector b(x[f[1]] - p);
        sum += plane ? crossing(a, b) : solidAngle(a, b, x[f[2]] - p);
    }
    return plane ? sum : sum/(4*constant::mathematical::pi);
}


Foam::scalar Foam::fsi::windingNumber
(
    const surfaceSet& surfaces,
    const label objecti,
    const point& p
)
{
    const label start = surfaces.faceStart()[objecti];
    return windingNumber
    (
        surfaces.points(),
        SubList<surfaceFace>
        (
            surfaces.faces(), surfaces.faceStart()[objecti + 1] - start, start
        ),
        p
    );
}


// ************************************************************************* //
