// SPDX-License-Identifier: GPL-3.0-or-later

// The film between two discs whose gap is narrower than a cell

#include <gtest/gtest.h>

#include "discSurfaces.H"
#include "discsInBox.H"
#include "mathematicalConstants.H"
#include "sphereSurfaces.H"
#include "sumOverRanks.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar radius = discsInBox::radius;

// Rows of cells between which films are looked at
const scalar lowest = 9;
const scalar highest = 12;


//- Two discs beside each other, the first one's right side at x
List<point> pairOfDiscs(const scalar x, const scalar gap)
{
    const scalar y = 0.5*(lowest + highest);
    return List<point>
    ({
        point(x - radius, y, 0), point(x + gap + radius, y, 0)
    });
}


//- Friction between two objects over the viscosity, where a place counts: of
//  the links without a cell, and of the links of cells in turn
template<class Counts>
scalar friction(const surfacesInBox& objects, const Counts& counts)
{
    const interfaceGeometry& geometry = objects.geometry();
    scalar sum = 0;
    for (const filmLink& link : geometry.betweenSurfaces())
    {
        const pointField& x = objects.surfaces().points();
        sum += counts(link.sides[0].place.interpolate(x))
          ? link.conductance : 0;
    }
    FixedList<scalarField, 2> ofCells;
    ofCells = scalarField(objects.mesh().nCells(), Zero);
    for (const wallLink& link : geometry.wallLinks())
    {
        ofCells[link.place.object][link.cell] += link.conductance;
    }
    forAll(ofCells[0], celli)
    {
        const scalar a = ofCells[0][celli];
        const scalar b = ofCells[1][celli];
        if (a*b > 0 && counts(objects.mesh().C()[celli]))
        {
            sum += a*b/(a + b);
        }
    }
    return overRanks(sum, sumOp<scalar>());
}


//- Part of a face that surfaces cover; its area is 1
scalar covered(const interfaceGeometry& geometry, const label facei)
{
    scalar sum = 0;
    for (const wallFace& w : geometry.wallFaces())
    {
        sum += w.face == facei ? w.area : 0;
    }
    return sum;
}


//- Integral of one over the gap between two circles
scalar exactFriction(const scalar gap)
{
    const label n = 300;
    const scalar dy = (highest - lowest)/n;
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar y = (i + 0.5)*dy - 0.5*(highest - lowest);
        const scalar depth = radius - Foam::sqrt(sqr(radius) - sqr(y));
        sum += dy/(gap + 2*depth);
    }
    return sum;
}

} // End anonymous namespace


TEST(films, carryTheShearBetweenTheirSurfaces)
{
    const auto inRows = [](const point& p)
    {
        return p.y() > lowest && p.y() < highest;
    };
    for (const direction split : {0, 1})
    {
        for (const scalar gap : {0.3, 0.5, 0.7})
        {
            scalar sum = 0;
            const label n = 5;
            for (label i = 0; i < n; ++i)
            {
                discsInBox discs(split);
                discs.move(pairOfDiscs(15.1 + i/scalar(n), gap));
                const scalar part = friction(discs, inRows)/exactFriction(gap);
                EXPECT_NEAR(part, 1, 0.2);
                sum += part;
            }
            EXPECT_NEAR(sum/n, 1, 0.08);
        }
    }
}


TEST(films, facesThatAreHardlyOpenHaveTheRestClosed)
{
    // Move the discs until the first one has just not closed a face, that of
    // the second is beyond
    const point middle(15.5, 10, 0);
    for (const direction split : {0, 1})
    {
        discsInBox discs(split);
        scalar open = 15.5, closed = 16.5;
        for (label i = 0; i < 45; ++i)
        {
            const scalar x = i < 44 ? 0.5*(open + closed) : open;
            discs.move(pairOfDiscs(x, 0.3));
            const interfaceGeometry& geometry = discs.geometry();
            scalar part = 0;
            for (const filmFace& film : geometry.films().faces())
            {
                const vector to(discs.mesh().faceCentres()[film.face] - middle);
                if (mag(to.x()) + mag(to.y()) > 0.1)
                {
                    continue;
                }
                part = geometry.openness()[film.face];
                EXPECT_NEAR(covered(geometry, film.face) + part, 1, 1e-12);
            }
            const scalar ofAll = overRanks(part, maxOp<scalar>());
            EXPECT_TRUE(i < 44 || (ofAll > 0 && ofAll < 2e-6)) << ofAll;
            (ofAll > 0 ? open : closed) = x;
        }
    }
}


TEST(films, openFacesByWhatIsBetweenBothSurfaces)
{
    const scalar gap = 0.3;
    for (const direction split : {0, 1})
    {
        // In the middle of a cell, and with a corner in it
        for (const scalar x : {15.35, 15.85})
        {
            discsInBox discs(split);
            discs.move(pairOfDiscs(x, gap));
            const interfaceGeometry& geometry = discs.geometry();
            const pointField& centres = discs.mesh().faceCentres();
            scalar open = 0;
            for (const filmFace& film : geometry.films().faces())
            {
                if
                (
                    film.dir == 1
                 && mag(centres[film.face].y() - 10) < 0.1
                 && !film.sides[1].isWall()
                )
                {
                    const scalar depth =
                        radius - Foam::sqrt(sqr(radius) - 0.25);
                    EXPECT_NEAR(film.gap, gap + 2*depth, 0.03);
                    open += geometry.openness()[film.face];
                    EXPECT_NEAR
                    (
                        covered(geometry, film.face)
                      + geometry.openness()[film.face],
                        1,
                        1e-9
                    );
                }
            }
            // A face on two ranks counts half on each
            const label atOnce =
                split == 1 && overRanks(open, sumOp<scalar>()) > 0.5 ? 2 : 1;
            EXPECT_NEAR
            (
                overRanks(open, sumOp<scalar>())/atOnce, gap + 0.035, 0.06
            );
        }
    }
}


TEST(films, areNotBetweenObjectsThatOverlap)
{
    for (const direction split : {0, 1})
    {
        discsInBox discs(split);
        discs.move(pairOfDiscs(15.4, -3));
        EXPECT_EQ(discs.geometry().betweenSurfaces().size(), 0);
        for (const filmFace& film : discs.geometry().films().faces())
        {
            const point& c = discs.mesh().faceCentres()[film.face];
            EXPECT_TRUE
            (
                (film.sides[1].isWall() && c.x() < 1)
             || mag(c.y() - 10.5) > 2
            );
        }
    }
}


TEST(films, areNotWhereASurfaceGoesOnInAnImage)
{
    for (const direction split : {0, 1})
    {
        surfacesInBox objects(labelVector(32, 20, 1), 2, split);
        surfaceSet discs(discSurfaces(pairOfDiscs(15.4, 5), radius, 96));
        discs.appendImages(labelList({0}), List<vector>({vector(0.2, 0, 0)}));
        objects.move(discs);
        for (const filmFace& film : objects.geometry().films().faces())
        {
            // Both discs are beside walls of the box
            EXPECT_TRUE(film.sides[1].isWall());
            const point& c = objects.mesh().faceCentres()[film.face];
            EXPECT_LT(min(min(c.x(), 32 - c.x()), min(c.y(), 20 - c.y())), 2.5);
        }
    }
}


TEST(films, betweenSpheresCarryTheShear)
{
    // Within a circle of radius a about the gap, both spheres with radius R:
    // 2 pi int r/(g + r^2/R) dr = pi R log(1 + a^2/(g R))
    const scalar R = 4.6;
    const scalar gap = 0.3;
    const scalar a = 1.5;
    const point middle(7.9, 7.2, 6.1);
    const vector along(vector(1, 0.2, -0.1)/mag(vector(1, 0.2, -0.1)));
    for (direction split = 0; split < 3; ++split)
    {
        surfacesInBox spheres(labelVector(16, 15, 13), 3, split);
        const vector away((R + 0.5*gap)*along);
        spheres.move
        (
            sphereSurfaces(List<point>({middle - away, middle + away}), R, 4)
        );
        const auto near = [&](const point& p)
        {
            return magSqr((p - middle) - ((p - middle) & along)*along) < sqr(a);
        };
        const scalar exact =
            constant::mathematical::pi*R*Foam::log(1 + sqr(a)/(gap*R));
        EXPECT_NEAR(friction(spheres, near)/exact, 1, 0.15);
    }
}


// ************************************************************************* //
