// SPDX-License-Identifier: GPL-3.0-or-later

// Shares of both surfaces in a gradient of the pressure along a thin film:
// half of the film each, (5.36), wherever the mesh is. Cells of size 1

#include <gtest/gtest.h>

#include "discSurfaces.H"
#include "sumOverRanks.H"
#include "surfacesInBox.H"
#include "wallOperator.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- The part of the film about its middle that has a gradient, and more; not the
//  films at the walls of the box
bool inFilm(const vector& fromMiddle, const scalar more)
{
    return mag(fromMiddle.x()) < 3 && mag(fromMiddle.y()) < 2 + more;
}

//- Volume of that part: half cells on both sides of each face
scalar openVolume(const surfacesInBox& discs, const point& middle)
{
    scalar open = 0;
    for (const filmFace& film : discs.geometry().films().faces())
    {
        const vector x(discs.mesh().faceCentres()[film.face] - middle);
        if (film.dir == vector::Y && inFilm(x, 0.1))
        {
            const bool internal = film.face < discs.mesh().nInternalFaces();
            open +=
                (inFilm(x, -0.1) ? 1 : 0.5)*(internal ? 1 : 0.5)
               *discs.geometry().openness()[film.face];
        }
    }
    return overRanks(open, sumOp<scalar>());
}

} // End anonymous namespace


TEST(filmShares, halvesOfAFilmWithoutAFluidCell)
{
    const scalar radius = 7.1;
    const scalar gap = 0.2;
    for (direction split = 0; split < 2; ++split)
    {
        for (const scalar offset : {-0.1, 0.0, 0.1})
        {
            const point middle(16 + offset, 16, 0);
            const vector away(radius + 0.5*gap, 0, 0);
            const List<point> centres({middle - away, middle + away});
            surfacesInBox discs(labelVector(32, 32, 1), 2, split);
            discs.move(discSurfaces(centres, radius, 96));
            wallOperator walls(discs.geometry());
            walls.update(discs.surfaces());

            vectorField gradient(discs.mesh().cellCentres() - middle);
            for (vector& g : gradient)
            {
                g = inFilm(g, 0) ? vector(0, 1, 0) : vector(Zero);
            }
            vectorField f;
            walls.gradientForce(gradient, f);
            FixedList<vector, 2> ofDisc(Zero);
            forAll(f, nodei)
            {
                ofDisc[discs.surfaces().pointObject()[nodei]] += f[nodei];
            }

            const scalar open = openVolume(discs, middle);
            EXPECT_GT(open, 1);
            for (const vector& force : ofDisc)
            {
                EXPECT_NEAR(force.y(), -0.5*open, 1e-10);
            }
        }
    }
}
