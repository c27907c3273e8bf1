// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "sharedPrediction.H"
#include "someObjects.H"

#include <gtest/gtest.h>

using namespace Foam;
using fsi::boxMesh;
using fsi::population;

TEST(predictShared, isThatOfEachGroupOnAnyRanks)
{
    // 43 discs, 5 blocks of copies and 3 left, and ellipses
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());
    for (label i = 0; i < 40; ++i)
    {
        objects->append
        (
            0, point(10 + 3*i, 2, 0), tensor::I, vector::zero, vector::zero
        );
    }
    someObjects::deform(*objects);

    List<Eigen::MatrixXd> force, v;
    objects->layout().zero(force);
    for (Eigen::MatrixXd& f : force)
    {
        f.setConstant(0.3);
    }
    fsi::predictShared(*objects, 0, 0.02, force, v);
    ASSERT_EQ(v.size(), 2);
    forAll(v, groupi)
    {
        Eigen::MatrixXd alone;
        objects->groups()[groupi].predict(0, 0.02, force[groupi], alone);
        EXPECT_TRUE(someObjects::same(v[groupi], alone));
    }
}


// ************************************************************************* //
