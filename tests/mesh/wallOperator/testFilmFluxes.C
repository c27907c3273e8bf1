// SPDX-License-Identifier: GPL-3.0-or-later

// The flux that both surfaces of a film carry, and its transpose (5.38). Cells
// of size 1

#include <gtest/gtest.h>

#include "atFace.H"
#include "discSurfaces.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"
#include "surfacesInBox.H"
#include "swapCoupledCells.H"
#include "wallOperator.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar radius = 7.1;

//- Two discs with a film of 0.2, whose line of centres is oblique
struct twoDiscs
:
    surfacesInBox
{
    const point middle;
    const vector away;
    wallOperator walls;

    explicit twoDiscs(const direction split)
    :
        surfacesInBox(labelVector(32, 32, 1), 2, split),
        middle(16.1, 15.8, 0),
        away((radius + 0.1)*vector(0.8, 0.6, 0)),
        walls(geometry())
    {
        const List<point> centres({middle - away, middle + away});
        move(discSurfaces(centres, radius, 96));
        walls.update(surfaces());
    }

    //- Each disc turns about its centre with its rate and moves
    vectorField velocities
    (
        const FixedList<scalar, 2>& rates,
        const FixedList<vector, 2>& speeds
    )
    {
        vectorField v(surfaces().points());
        forAll(v, i)
        {
            const label disc = surfaces().pointObject()[i];
            const vector arm(v[i] - middle + (disc == 0 ? 1 : -1)*away);
            v[i] = speeds[disc] + (vector(0, 0, rates[disc]) ^ arm);
        }
        return v;
    }
};

} // End anonymous namespace


TEST(filmFluxes, isTheTransposeOfItsTranspose)
{
    for (direction split = 0; split < 2; ++split)
    {
        twoDiscs discs(split);
        discs.walls.setFilms(3, 0.5);
        const scalarField p
        (
            cos(0.3*discs.mesh().cellCentres().component(0))
          + sin(0.2*discs.mesh().cellCentres().component(1))
        );
        const vectorField v
        (
            discs.velocities({0.1, 0.3}, {vector(1, 2, 0), vector(-1, 1, 0)})
        );
        // J' v less the flux with films: without that of films
        scalarField less(p.size());
        vectorField with, without;
        discs.walls.flux(v, less, &v);
        discs.walls.transposeAtWalls(discs.walls.atWalls(p), with, true);
        discs.walls.transpose(p, without);
        const scalar work = sum((with - without) & v);
        EXPECT_GT(mag(work), 0.1);
        EXPECT_NEAR(-gSum((p*less)()), work, 1e-12);
        EXPECT_NEAR(gSum(less), 0, 1e-12);
    }
}


TEST(filmFluxes, carryTheFilmWithItsSurfaces)
{
    for (direction split = 0; split < 2; ++split)
    {
        twoDiscs discs(split);
        const scalar tau = 2, viscosity = 0.5;
        discs.walls.setFilms(tau, viscosity);
        const vector u(3, -2, 0);
        surfaceScalarField phi
        (
            IOobject("phi", "0", discs.mesh()),
            discs.mesh(),
            dimensionedScalar(dimVolume/dimTime, Zero)
        );
        setOriented(phi);
        discs.walls.inFilms().addFaceFlux
        (
            discs.velocities({0, 0}, {u, u}), phi
        );
        label nFilms = 0;
        for (const filmFace& film : discs.geometry().films().faces())
        {
            if (film.sides[0].isWall() || film.sides[1].isWall())
            {
                continue;
            }
            const scalar kept =
                discs.geometry().films().kept(film.face, tau, viscosity);
            const scalar along = discs.grid().faceAlong(film.face) ? 1 : -1;
            EXPECT_NEAR
            (
                atFace(phi, film.face),
                along*(1 - kept)*discs.geometry().openness()[film.face]
               *u[film.dir],
                1e-12
            );
            ++nFilms;
        }
        EXPECT_GT(overRanks(nFilms, sumOp<label>()), 5);
    }
}


// ************************************************************************* //
