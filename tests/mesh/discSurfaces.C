// SPDX-License-Identifier: GPL-3.0-or-later

#include "discSurfaces.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::surfaceSet Foam::fsi::discSurfaces
(
    const UList<point>& centres,
    const scalar radius,
    const label n
)
{
    surfaceSet surfaces(2);
    for (const point& centre : centres)
    {
        pointField points(n);
        List<surfaceFace> faces(n);
        for (label i = 0; i < n; ++i)
        {
            const scalar a = 2*constant::mathematical::pi*(i + 0.3)/n;
            points[i] = centre + radius*vector(Foam::cos(a), Foam::sin(a), 0);
            faces[i] = surfaceFace({i, (i + 1) % n, -1});
        }
        surfaces.append(points, faces);
    }
    return surfaces;
}


// ************************************************************************* //
