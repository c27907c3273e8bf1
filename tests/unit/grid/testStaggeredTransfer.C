// SPDX-License-Identifier: GPL-3.0-or-later

#include "staggeredTransfer.H"
#include "pointField.H"

#include <gtest/gtest.h>
#include <random>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;
typedef staggeredTransfer::faceArrays arrays;

//- Box of 8 x 7 x 6 cells of size 0.5, cyclic along x and z
staggeredLattice lattice(const direction nDims)
{
    staggeredLattice result;
    result.origin = point(-1, 2, 3);
    result.spacing = 0.5;
    result.nDims = nDims;
    result.all = labelVector(8, 7, nDims == 2 ? 1 : 6);
    result.cyclic[0] = true;
    result.cyclic[1] = false;
    result.cyclic[2] = nDims == 3;
    result.start = labelVector::zero;
    result.n = result.all;
    return result;
}


arrays zeros(const staggeredLattice& box)
{
    arrays result;
    for (scalarField& values : result)
    {
        values = scalarField(box.size(), Zero);
    }
    return result;
}


//- Places up to a period outside along x, and 1.1 cells from the sides along y
pointField places(const staggeredLattice& box, const label n)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<scalar> in(0, 1);
    pointField result(n);
    for (point& p : result)
    {
        const vector part(3*in(random) - 1, 0, in(random));
        p = box.origin + box.spacing*cmptMultiply(part, vector(8, 7, 6));
        p.y() += box.spacing*(1.1 + 4.8*in(random));
    }
    return result;
}


vectorField someVectors(const label n)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<scalar> in(-1, 1);
    vectorField result(n);
    for (vector& v : result)
    {
        v = vector(in(random), in(random), in(random));
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(staggeredTransfer, spreadingIsTheTransposeOfInterpolation)
{
    for (const direction nDims : {2, 3})
    {
        for (const label width : {2, 3, 4})
        {
            const staggeredLattice box(lattice(nDims));
            const staggeredTransfer transfer(box, width);
            const pointField x(places(box, 50));
            const vectorField force(someVectors(50));
            arrays faces(zeros(box)), u(zeros(box));
            transfer.spread(x, force, faces);
            scalar power = 0;
            vector sum(Zero);
            for (direction d = 0; d < nDims; ++d)
            {
                const vectorField values(someVectors(box.size()));
                u[d] = values.component(d);
                power += Foam::sum(u[d]*faces[d]);
                sum[d] = Foam::sum(faces[d]);
            }
            vectorField v(50);
            transfer.interpolate(x, u, v);
            scalar ofNodes = 0;
            vector forces(Zero);
            forAll(v, i)
            {
                for (direction d = 0; d < nDims; ++d)
                {
                    ofNodes += v[i][d]*force[i][d];
                    forces[d] += force[i][d];
                }
            }
            EXPECT_NEAR(power, ofNodes, 1e-12);
            EXPECT_NEAR(mag(sum - forces), 0, 1e-12);
        }
    }
}


TEST(staggeredTransfer, interpolatesALinearFlow)
{
    const staggeredLattice box(lattice(3));
    const labelVector n(box.length(0), box.length(1), box.length(2));
    arrays u(zeros(box));
    for (label place = 0; place < box.size(); ++place)
    {
        // u = (y, 3, -y), of faces with their centres half a cell further
        const scalar y =
            box.origin.y()
          + box.spacing
           *((place/n.x()) % n.y() - staggeredLattice::halo + 0.5);
        u[0][place] = y;
        u[1][place] = 3;
        u[2][place] = -y;
    }
    const pointField x(places(box, 50));
    for (const label width : {2, 3, 4})
    {
        vectorField v(50);
        staggeredTransfer(box, width).interpolate(x, u, v);
        forAll(v, i)
        {
            EXPECT_NEAR(v[i].x(), x[i].y(), 1e-12);
            EXPECT_NEAR(v[i].y(), 3, 1e-12);
            EXPECT_NEAR(v[i].z(), -x[i].y(), 1e-12);
        }
    }
}


TEST(staggeredTransfer, blocksOfADomainHaveTheSumOfTheWhole)
{
    // Two blocks, cut along the cyclic x, hold each face once between them;
    // the second one holds the first face of the first one, too
    const staggeredLattice all(lattice(3));
    const pointField x(places(all, 50));
    const vectorField force(someVectors(50));
    arrays whole(zeros(all));
    staggeredTransfer(all, 3).spread(x, force, whole);
    for (const label part : {0, 1})
    {
        staggeredLattice half(all);
        half.start.x() = part*3;
        half.n.x() = part ? 5 : 3;
        arrays faces(zeros(half));
        staggeredTransfer(half, 3).spread(x, force, faces);
        for (direction d = 0; d < 3; ++d)
        {
            for (label i = 0; i <= half.n.x() - (d != 0); ++i)
            {
                const labelVector ijk(half.start.x() + i, 3, 2);
                EXPECT_NEAR
                (
                    faces[d][half.place(ijk)], whole[d][all.place(ijk)], 1e-13
                );
            }
        }
    }
}


// ************************************************************************* //
