// SPDX-License-Identifier: GPL-3.0-or-later

// Thickness of the film between two spheres

#include <gtest/gtest.h>

#include "sphereSurfaces.H"
#include "sumOverRanks.H"
#include "surfacesInBox.H"

using namespace Foam;
using namespace Foam::fsi;


TEST(films, areAsThinAsCurvedSurfacesLeaveThem)
{
    const scalar R = 4;
    const point middle(7.9, 7.2, 6.5);
    for (const scalar gap : {0.1, 0.3})
    {
        const auto thickness = [&](const scalar x, const scalar y)
        {
            const scalar r2 = sqr(x - middle.x()) + sqr(y - middle.y());
            return gap + 2*(R - Foam::sqrt(sqr(R) - r2));
        };
        for (direction split = 0; split < 3; ++split)
        {
            surfacesInBox spheres(labelVector(16, 15, 13), 3, split);
            const vector away(0, 0, R + 0.5*gap);
            spheres.move
            (
                sphereSurfaces
                (
                    List<point>({middle - away, middle + away}), R, 5
                )
            );
            label n = 0;
            for (const filmFace& film : spheres.geometry().films().faces())
            {
                const point& c = spheres.mesh().faceCentres()[film.face];
                const vector from(c - middle);
                if (film.dir == 2 || mag(from.z()) > 0.1 || mag(from) > 1.3)
                {
                    continue;
                }
                ++n;
                // Along the face and from centre to centre
                scalar open = 0, cubes = 0;
                for (const label i : {-1, 0, 1})
                {
                    const scalar s = 0.5*i;
                    const scalar a = film.dir == 0 ? s : 0;
                    const scalar weight = i == 0 ? 4.0/6 : 1.0/6;
                    open += weight*thickness(c.x() + s - a, c.y() + a);
                }
                const label nParts = 50;
                for (label i = 0; i < nParts; ++i)
                {
                    const scalar s = (i + 0.5)/nParts - 0.5;
                    const scalar a = film.dir == 0 ? s : 0;
                    cubes +=
                        1/pow3(thickness(c.x() + a, c.y() + s - a))/nParts;
                }
                const scalar resistance = thickness(c.x(), c.y())*cubes;
                EXPECT_NEAR
                (
                    spheres.geometry().openness()[film.face]/open, 1, 0.05
                );
                EXPECT_NEAR(film.resistance/resistance, 1, 0.15);
            }
            EXPECT_GT(overRanks(n, sumOp<label>()), 5);
        }
    }
}


// ************************************************************************* //
