// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidSamples.H"
#include "OStringStream.H"

#include <gtest/gtest.h>

using namespace rigidSamples;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(rigidBodies, goOnBitByBit)
{
    for (const direction nDims : {2, 3})
    {
        auto shape = rigidShape
        (
            blockSurface(vector(0.3, 0.2, 0.1), nDims), nDims
        );
        auto group = bodyGroup::New(*shape, dictionary());
        for (label i = 0; i < 2; ++i)
        {
            group->append
            (
                point(i, 1, 0), tensor::I, vector(1, i, 0), vector(0, 0, 2), i
            );
        }
        const Eigen::MatrixXd force
        (
            Eigen::MatrixXd::Constant(shape->nNodes(), 2*nDims, 0.7)
        );
        for (label i = 0; i < 5; ++i)
        {
            advance(*group, force, 1e-2);
        }

        OStringStream shapeText;
        shape->write(shapeText);
        const shapeTemplate restoredShape
        {
            dictionary(IStringStream(shapeText.str())())
        };
        EXPECT_EQ(restoredShape.nNodes(), shape->nNodes());
        EXPECT_TRUE(restoredShape.nodeMasses() == shape->nodeMasses());
        OStringStream text;
        group->write(text);
        auto restored = bodyGroup::New(restoredShape, dictionary());
        restored->read(dictionary(IStringStream(text.str())()));
        for (label i = 0; i < 5; ++i)
        {
            advance(*group, force, 1e-2);
            advance(*restored, force, 1e-2);
        }
        EXPECT_EQ(group->positions(), restored->positions());
        EXPECT_EQ(group->velocities(), restored->velocities());
    }
}


TEST(rigidBodies, needNoElements)
{
    // A surface alone is rigid, or has a prescribed motion
    const shapeMesh mesh(blockSurface(vector(0.3, 0.2, 0.1), 2));
    auto soft = rigidShape(mesh, 2, "density 1000; E 1e4;");
    EXPECT_THROW(bodyGroup::New(*soft, dictionary()), Foam::IOerror);
    EXPECT_FALSE
    (
        bodyGroup::New(*soft, dictionaryOf("type fixed;"))->movesFreely()
    );
    EXPECT_THROW
    (
        rigidShape(mesh, 2, "type rigid; density 1000; E 1e4;"), Foam::IOerror
    );
}


// ************************************************************************* //
