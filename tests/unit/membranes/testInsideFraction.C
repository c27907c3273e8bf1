// SPDX-License-Identifier: GPL-3.0-or-later

#include "insideFraction.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Cells of size 0.5 in a box from (-4, -4, -4), cyclic along x
staggeredLattice lattice()
{
    staggeredLattice box;
    box.origin = vector::uniform(-4);
    box.spacing = 0.5;
    box.nDims = 3;
    box.all = labelVector::uniform(16);
    box.cyclic = false;
    box.cyclic[0] = true;
    box.start = labelVector::zero;
    box.n = box.all;
    return box;
}


//- Surface of a box
shapeMesh brick(const point& low, const point& high)
{
    shapeMesh mesh;
    for (label i = 0; i < 8; ++i)
    {
        mesh.points.append
        (
            point
            (
                i & 1 ? high.x() : low.x(),
                i & 2 ? high.y() : low.y(),
                i & 4 ? high.z() : low.z()
            )
        );
    }
    mesh.faces = List<surfaceFace>
    ({
        {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
        {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}
    });
    return mesh;
}


scalar at
(
    const staggeredLattice& box,
    const scalarField& fraction,
    const label i, const label j, const label k
)
{
    return fraction[box.place(labelVector(i, j, k))];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(insideFraction, brickIsExactAlongRays)
{
    // Along x from 0.3 of cell 2 to 0.6 of cell 4, along y and z whole cells
    const staggeredLattice box(lattice());
    const shapeMesh mesh
    (
        brick(point(-2.85, -3, -2), point(-1.7, -2, -1.5))
    );
    scalarField fraction(box.size(), Zero), values(fraction);
    insideFraction(box).add(mesh.points, mesh.faces, 3, fraction, values);
    EXPECT_NEAR(at(box, fraction, 2, 2, 4), 0.7, 1e-12);
    EXPECT_NEAR(at(box, fraction, 3, 3, 4), 1, 1e-12);
    EXPECT_NEAR(at(box, fraction, 4, 2, 4), 0.6, 1e-12);
    EXPECT_NEAR(sum(fraction), 2.3*2, 1e-12);
    EXPECT_NEAR(sum(values), 3*2.3*2, 1e-12);
}


TEST(insideFraction, goesRoundACyclicDomain)
{
    const staggeredLattice box(lattice());
    const shapeMesh mesh(brick(point(3.5, 0, 0), point(4.75, 0.5, 0.5)));
    scalarField fraction(box.size(), Zero), values(fraction);
    insideFraction(box).add(mesh.points, mesh.faces, 3, fraction, values);
    EXPECT_NEAR(at(box, fraction, 15, 8, 8), 1, 1e-12);
    EXPECT_NEAR(at(box, fraction, 0, 8, 8), 1, 1e-12);
    EXPECT_NEAR(at(box, fraction, 1, 8, 8), 0.5, 1e-12);
}


TEST(insideFraction, sphereHasItsVolume)
{
    const staggeredLattice box(lattice());
    const dictionary shape(dictionaryOf("type sphere; radius 3;"));
    const meshGrading grading((dictionary()));
    shapeMesh mesh(newShapeMesh(shape, 3, 0.5, grading, false));
    mesh.points += vector(0.13, 0.21, -0.07);
    scalarField fraction(box.size(), Zero), values(fraction);
    insideFraction(box).add(mesh.points, mesh.faces, 3, fraction, values);
    const scalar volume = sum(fraction)*pow3(0.5);
    EXPECT_NEAR(volume/113.097, 1, 0.005);
    EXPECT_GT(min(fraction), -1e-12);
    EXPECT_LT(max(fraction), 1 + 1e-12);
}


// ************************************************************************* //
