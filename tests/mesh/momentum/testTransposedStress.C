// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "discsInBox.H"
#include "sphereSurfaces.H"
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


//- Force on the surfaces of bodies that move with a field, and its sums
struct movedBodies
{
    vectorField force;
    scalar power = 0;
    vector torque = Zero;

    movedBodies
    (
        const surfacesInBox& bodies,
        const vectorField& v
    )
    :
        force(v.size(), Zero)
    {
        const surfaceSet& surfaces = bodies.surfaces();
        addTransposedForce
        (
            transposedModes(surfaces, bodies.geometry(), viscosity),
            surfaces.pointStart(),
            v,
            force
        );
        forAll(v, i)
        {
            power += force[i] & v[i];
            torque += surfaces.points()[i] ^ force[i];
        }
    }
};


//- Discs that rotate and strain
struct movedDiscs
:
    movedBodies
{
    static vectorField velocities(const pointField& x, const vector& rates)
    {
        vectorField v(x.size());
        forAll(x, i)
        {
            v[i] = velocity(rates, x[i]);
        }
        return v;
    }

    movedDiscs(const discsInBox& discs, const vector& rates)
    :
        movedBodies
        (
            discs, velocities(discs.surfaces().points(), rates)
        )
    {}
};


//- Wall faces that reach the surface nodes
scalarField facesOfNodes(const surfacesInBox& discs)
{
    scalarField faces(discs.surfaces().points().size(), Zero);
    for (const wallLink& link : discs.geometry().wallLinks())
    {
        link.place.spread(faces, 1.0);
    }
    sumOverRanks(faces);
    return faces;
}


//- Sums of t^2 over the wall faces, of the modes on an object
scalarField drivesOfLinks(const surfacesInBox& bodies, const label objecti)
{
    const scalarField faces(facesOfNodes(bodies));
    const labelList& start = bodies.surfaces().pointStart();
    const std::vector<transposedMode> modes
    (
        transposedModes(bodies.surfaces(), bodies.geometry(), viscosity)
    );
    scalarField drives(modes.size(), Zero);
    forAll(drives, k)
    {
        for (label i = start[objecti]; i < start[objecti + 1]; ++i)
        {
            drives[k] +=
                faces[i] > 0 ? magSqr(modes[k].vectors[i])/faces[i] : 0;
        }
    }
    return drives;
}


//- The largest of them
scalar driveOfLinks(const surfacesInBox& bodies, const label objecti)
{
    return max(drivesOfLinks(bodies, objecti));
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
            const movedDiscs all(discs, rates);
            const scalar omega = rates[0];
            const scalar strain = sqr(rates[1]) + sqr(rates[2]);
            const scalar expected = strength*(strain - sqr(omega));
            EXPECT_NEAR(all.power, expected, 1e-9*strength);
            EXPECT_NEAR(all.torque.z(), -strength*omega, 1e-9*strength);
            EXPECT_LT(mag(sum(all.force)), 1e-9*strength);
        }
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
        const movedDiscs moved(discs, vector(1, 2, 3));
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
        const movedDiscs moved(discs, vector(1, 2, 3));
        EXPECT_TRUE(std::isfinite(moved.power));
    }
}


TEST(TransposedStress, powerAndTorqueInSpaceAreThoseOfTheExactStress)
{
    // Strains free of divergence with rotations about any axis
    const List<tensor> fields
    ({
        tensor(0, -1, 0, 1, 0, 0, 0, 0, 0),
        tensor(0, 0.3, -0.5, -0.3, 0, 0.7, 0.5, -0.7, 0),
        tensor(1, 0, 0, 0, 1, 0, 0, 0, -2),
        tensor(0.2, 1, -0.4, 0.1, -0.5, 0.3, 0.6, 0.9, 0.3)
    });
    for (direction split = 0; split < 3; ++split)
    {
        surfacesInBox spheres(labelVector(16, 14, 12), 3, split);
        const point centre(8.3, 7.2, 6.1);
        spheres.move(sphereSurfaces(List<point>({centre}), 4.3, 3));
        const pointField& x = spheres.surfaces().points();
        const scalar strength = viscosity*spheres.surfaces().volume(0);
        for (const tensor& G : fields)
        {
            const vectorField v(vector(3, 1, 2) + (G & x));
            const tensor R(skew(G));
            const vector spin(R.zy(), R.xz(), R.yx());
            const movedBodies all(spheres, v);
            EXPECT_NEAR(all.power, strength*tr(G & G), 1e-9*strength);
            EXPECT_LT(mag(all.torque + 2*strength*spin), 1e-9*strength);
            EXPECT_LT(mag(sum(all.force)), 1e-9*strength);
        }

        // 3/2 faces per h^2 of a sphere: mu V 3/(6 pi R^4)
        EXPECT_NEAR(driveOfLinks(spheres, 0)/viscosity, 2/(3*4.3), 0.01);

        // A cap of one sphere looks out between others: as much as the sum of
        // E^2 over the strains, 5/3, of the least that half of h allows, 3/4
        const List<point> centres
        ({
            centre, centre + vector(1, 1.5, 0), centre - vector(0, 1.5, 1)
        });
        spheres.move(sphereSurfaces(centres, 4.3, 3));
        const scalarField drives(drivesOfLinks(spheres, 0));
        const label nStrains = drives.size() - nRotations(3);
        EXPECT_EQ(nStrains, 5);
        EXPECT_LE(max(drives), 0.5*viscosity);
        const SubList<scalar> strains(drives, nStrains, nRotations(3));
        EXPECT_NEAR(sum(strains), 1.25*viscosity, 1e-9);
    }
}


// ************************************************************************* //
