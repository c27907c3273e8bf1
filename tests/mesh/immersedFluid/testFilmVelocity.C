// SPDX-License-Identifier: GPL-3.0-or-later

// Velocity of the film between two discs that slide on each other

#include <gtest/gtest.h>

#include "discSurfaces.H"
#include "sumOverRanks.H"
#include "surfacesInBox.H"
#include "unitConversion.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar radius = 7.1;
const scalar gap = 0.2;


//- Where a line from a point in the direction of an axis cuts a circle, the
//  place that is nearer to the point
scalar cut(const point& from, const direction axis, const point& centre)
{
    const vector away(from - centre);
    const scalar square = sqr(away[axis]) + sqr(radius) - magSqr(away);
    const scalar root = Foam::sqrt(max(square, scalar(0)));
    return away[axis] > 0 ? root - away[axis] : -root - away[axis];
}

} // End anonymous namespace


TEST(films, openAtTheirEndsAsTheirSurfacesMove)
{
    const vector normal(0.8, 0.6, 0);
    const point middle(16.3, 16.1, 0);
    const vector away((radius + 0.5*gap)*normal);
    for (direction split = 0; split < 2; ++split)
    {
        surfacesInBox discs(labelVector(32, 32, 1), 2, split);
        discs.move
        (
            discSurfaces
            (
                List<point>({middle - away, middle + away}), radius, 96
            )
        );
        const labelUList& object = discs.surfaces().pointObject();
        const vector wind(1, 2, 0);
        const vectorField together(object.size(), wind);
        vectorField apart(object.size());
        vectorField sliding(object.size());
        forAll(apart, i)
        {
            const scalar sign = object[i] == 0 ? -1 : 1;
            apart[i] = sign*normal;
            sliding[i] = sign*vector(-normal.y(), normal.x(), 0);
        }
        label n = 0;
        for (const filmFace& film : discs.geometry().films().faces())
        {
            if (film.perOpening <= 0)
            {
                continue;
            }
            const vector u(film.meanVelocity(together));
            EXPECT_NEAR(mag(u - wind), 0, 1e-12);
            for (const filmEnd& end : film.ends)
            {
                EXPECT_NEAR(end.opening(together, u), 0, 1e-12);
                EXPECT_NEAR(end.opening(sliding, vector::zero), 0, 5e-3);
                const vector across
                (
                    (film.sides[0].place.object == 0 ? 1 : -1)
                   *(end.normals[0] - end.normals[1])
                );
                EXPECT_NEAR
                (
                    end.opening(apart, vector::zero), across & normal, 1e-12
                );
                EXPECT_GT(across & normal, 1);
                ++n;
            }
        }
        EXPECT_GT(overRanks(n, sumOp<label>()), 20);
    }
}


TEST(films, moveByTheirPartsOnBothSidesOfTheMiddle)
{
    // The flow along the film has no net flux through any section across it.
    // Through an oblique one it has what is more on one side of the middle
    const point middle(16.3, 16.1, 0);
    label n = 0;
    scalar largest = 0;
    for (const scalar angle : {20, 35, 50, 70})
    {
        const scalar a = degToRad(angle);
        const vector normal(Foam::cos(a), Foam::sin(a), 0);
        const vector along(-normal.y(), normal.x(), 0);
        const vector away((radius + 0.5*gap)*normal);
        const List<point> centres({middle - away, middle + away});
        surfacesInBox discs(labelVector(32, 32, 1), 2, 0);
        discs.move(discSurfaces(centres, radius, 96));

        const labelUList& object = discs.surfaces().pointObject();
        vectorField nodal(object.size());
        forAll(nodal, i)
        {
            nodal[i] = object[i] == 0 ? along : vector(-along);
        }
        for (const filmFace& film : discs.geometry().films().faces())
        {
            point c(discs.mesh().faceCentres()[film.face]);
            c.z() = 0;
            if
            (
                mag(c - middle) > 2
             || min(film.closed[0], film.closed[1]) < 0.01
            )
            {
                continue;
            }
            ++n;
            const direction axis = 1 - film.dir;
            const scalar first = cut(c, axis, centres[0]);
            const scalar second = cut(c, axis, centres[1]);
            const scalar half = ((middle - c) & normal)/normal[axis];
            const scalar exact =
                along[film.dir]*(2*half - first - second)/(second - first);
            EXPECT_NEAR(film.velocity(nodal), exact, 0.02);
            largest = max(largest, mag(exact));
        }
    }
    EXPECT_GT(overRanks(n, sumOp<label>()), 10);
    EXPECT_GT(overRanks(largest, maxOp<scalar>()), 0.08);
}


// ************************************************************************* //
