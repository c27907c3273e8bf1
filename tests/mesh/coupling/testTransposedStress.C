// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "discsInBox.H"
#include "sumOverRanks.H"
#include "transposedStress.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar viscosity = 0.7;

const point left(8.3, 10.2, 0);


//- A linear velocity field: rotation and two strains
vector velocity(const vector& rates, const point& x)
{
    const scalar omega = rates[0];
    const scalar a = rates[1];
    const scalar b = rates[2];
    return vector
    (
        3 + a*x.x() + (b - omega)*x.y(),
        (b + omega)*x.x() - a*x.y(),
        0
    );
}


//- Force on the surfaces of discs that move with a field, and its sums
struct movedDiscs
{
    vectorField force;
    scalar power = 0;
    scalar torque = 0;

    movedDiscs(const discsInBox& discs, const vector& rates, const bool linear)
    :
        force(discs.surfaces().points().size(), Zero)
    {
        const surfaceSet& surfaces = discs.surfaces();
        const pointField& x = surfaces.points();
        vectorField v(x.size());
        forAll(x, i)
        {
            v[i] = velocity(rates, x[i]);
        }
        addTransposedForce
        (
            transposedModes(surfaces, discs.geometry(), viscosity, linear),
            surfaces.pointStart(),
            v,
            force
        );
        forAll(x, i)
        {
            power += force[i] & v[i];
            torque += (x[i] ^ force[i]).z();
        }
    }
};


//- Wall faces that reach the surface nodes
scalarField facesOfNodes(const discsInBox& discs)
{
    scalarField faces(discs.surfaces().points().size(), Zero);
    for (const wallLink& link : discs.geometry().wallLinks())
    {
        link.place.spread(faces, 1.0);
    }
    sumOverRanks(faces);
    return faces;
}


//- The largest sum of t^2 over the wall faces, of the modes on an object
scalar driveOfLinks(const discsInBox& discs, const label objecti)
{
    const scalarField faces(facesOfNodes(discs));
    const labelList& start = discs.surfaces().pointStart();
    scalar largest = 0;
    for
    (
        const transposedMode& mode
      : transposedModes(discs.surfaces(), discs.geometry(), viscosity, true)
    )
    {
        scalar drive = 0;
        for (label i = start[objecti]; i < start[objecti + 1]; ++i)
        {
            drive += faces[i] > 0 ? magSqr(mode.vectors[i])/faces[i] : 0;
        }
        largest = max(largest, drive);
    }
    return largest;
}

} // End anonymous namespace


TEST(TransposedStress, powerAndTorqueAreThoseOfTheExactStress)
{
    for (const direction split : {0, 1})
    {
        discsInBox discs(split);
        discs.move({left + vector(3.2, 0, 0)});
        const scalar strength = 2*viscosity*discs.surfaces().volume(0);
        for
        (
            const vector& rates
          : {vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1), vector(2, 3, 1)}
        )
        {
            const movedDiscs all(discs, rates, true);
            const scalar omega = rates[0];
            const scalar strain = sqr(rates[1]) + sqr(rates[2]);
            const scalar expected = strength*(strain - sqr(omega));
            EXPECT_NEAR(all.power, expected, 1e-9*strength);
            EXPECT_NEAR(all.torque, -strength*omega, 1e-9*strength);
            EXPECT_LT(mag(sum(all.force)), 1e-9*strength);
        }
        const movedDiscs turning(discs, vector(1, 0, 0), false);
        EXPECT_NEAR(turning.torque, -strength, 1e-9*strength);
        EXPECT_NEAR(turning.power, -strength, 1e-9*strength);
    }
}


TEST(TransposedStress, nodesWithoutFluidFeelNothing)
{
    for (const direction split : {0, 1})
    {
        // So near that no cell's centre is between
        discsInBox discs(split);
        discs.move({left, left + vector(2*discsInBox::radius + 0.1, 0.4, 0)});
        const scalarField faces(facesOfNodes(discs));
        const movedDiscs moved(discs, vector(1, 2, 3), true);
        label dry = 0;
        forAll(faces, i)
        {
            dry += faces[i] == 0;
            EXPECT_EQ(faces[i] > 0, mag(moved.force[i]) > 0) << i;
        }
        EXPECT_GT(dry, 3);
    }
}


TEST(TransposedStress, objectsThatTheFluidHardlyTouchesAreDrivenLess)
{
    for (const direction split : {0, 1})
    {
        discsInBox discs(split);
        discs.move({left + vector(3.2, 0, 0)});
        EXPECT_LT(driveOfLinks(discs, 0), 0.15*viscosity);

        // A strip of one disc looks out beside two others
        const point centre(left + vector(3.2, 0, 0));
        discs.move
        ({
            centre,
            centre + vector(1.5, 3, 0),
            centre + vector(1.5, -3, 0)
        });
        EXPECT_NEAR(driveOfLinks(discs, 0), 0.5*viscosity, 1e-9);

        // No fluid about one of them
        discs.move({left + vector(3.2, 0, 0), left + vector(3.2, 0, 0)});
        const movedDiscs moved(discs, vector(1, 2, 3), true);
        const movedDiscs turned(discs, vector(1, 2, 3), false);
        EXPECT_TRUE(std::isfinite(moved.power));
        EXPECT_TRUE(std::isfinite(turned.power));
    }
}


// ************************************************************************* //
