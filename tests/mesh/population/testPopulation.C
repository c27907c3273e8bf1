// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "nodeVelocities.H"
#include "someObjects.H"
#include "PstreamReduceOps.H"
#include "needsThrownErrors.H"
#include "../../unit/samples/newShapeTemplate.H"

using namespace Foam;
using Foam::fsi::boxMesh;
using Foam::fsi::bodyGroup;
using Foam::fsi::population;

namespace
{

//- Ids of all objects in the order of the population
labelList ids(const population& objects)
{
    labelList result(objects.size());
    forAll(result, objecti)
    {
        result[objecti] = objects.objectId(objecti);
    }
    return result;
}


//- Expect the state and the shape of two groups to be bitwise the same
void expectSame(const bodyGroup& a, const bodyGroup& b)
{
    EXPECT_EQ(a.objectIds(), b.objectIds());
    EXPECT_TRUE(someObjects::same(a.positions(), b.positions()));
    EXPECT_TRUE(someObjects::same(a.velocities(), b.velocities()));
    EXPECT_EQ(a.shape().points(), b.shape().points());
    EXPECT_EQ(a.shape().springConstants(), b.shape().springConstants());
    EXPECT_EQ(a.shape().restLengths(), b.shape().restLengths());
    EXPECT_EQ(a.shape().nodeMasses(), b.shape().nodeMasses());

    // The state of the springs shows in the force and in the next step
    Eigen::MatrixXd fa, fb;
    a.internalForce(fa);
    b.internalForce(fb);
    EXPECT_TRUE(someObjects::same(fa, fb));
    fa.setConstant(0.1);
    Eigen::MatrixXd va, vb;
    a.predict(0, 0.02, fa, va);
    b.predict(0, 0.02, fa, vb);
    EXPECT_TRUE(someObjects::same(va, vb));
}


//- Write a deformed population, read it again and expect the same
void testRoundTrip(const word& writeFormat)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    const autoPtr<Time> time = someObjects::makeTime(box, writeFormat);
    autoPtr<population> written = someObjects::make(time());
    someObjects::deform(*written);
    written->remove(labelList(1, label(1)));
    written->writeShapes();
    written->write();
    label ready = 1;
    reduce(ready, sumOp<label>());

    population read(time());
    EXPECT_EQ(read.nDims(), 2);
    EXPECT_EQ(read.planeZ(), 0.5);
    EXPECT_EQ(ids(read), ids(*written));
    ASSERT_EQ(read.groups().size(), 2);
    for (label groupi = 0; groupi < 2; ++groupi)
    {
        EXPECT_EQ(read.shape(groupi).name(), written->shape(groupi).name());
        expectSame(read.groups()[groupi], written->groups()[groupi]);
    }
    EXPECT_EQ(read.surfaces().points(), written->surfaces().points());
    EXPECT_EQ(read.surfaces().velocities(), written->surfaces().velocities());

    // The id of a removed object is not used again
    EXPECT_EQ
    (
        read.append(0, point(5, 5, 0), tensor::I, vector::zero, vector::zero),
        5
    );
}

} // End namespace


TEST(Population, numbersObjectsGroupAfterGroup)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());

    EXPECT_EQ(objects->size(), 5);
    EXPECT_EQ(ids(*objects), labelList({0, 1, 2, 3, 4}));
    EXPECT_EQ(fsi::indexOf(objects->shapeNames(), word("ellipse")), 1);
    EXPECT_EQ(fsi::indexOf(objects->shapeNames(), word("square")), -1);
    EXPECT_EQ(objects->objectGroup(4), 1);
    EXPECT_EQ(objects->objectCopy(4), 1);
    EXPECT_EQ(objects->objectIndex(1, 1), 4);
    EXPECT_EQ(objects->findObject(2), 2);
    EXPECT_EQ(objects->findObject(7), -1);
    EXPECT_EQ(objects->surfaces().size(), 5);
    EXPECT_EQ
    (
        objects->nNodes(),
        3*objects->shape(0).nNodes() + 2*objects->shape(1).nNodes()
    );
}


TEST(Population, surfacesFollowTheGroups)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());

    const point centre = objects->surfaces().centroid(4);
    EXPECT_NEAR(centre.x(), 6, 1e-12);
    EXPECT_NEAR(centre.y(), 6, 1e-12);
    const boundBox turned = objects->surfaces().bounds(4);
    EXPECT_NEAR(turned.span().x(), 1.6, 0.05);
    EXPECT_NEAR(turned.span().y(), 3.0, 0.05);
    EXPECT_EQ(turned.min().z(), 0.5);
    EXPECT_EQ(turned.max().z(), 0.5);

    // Rigid motion v + omega x r of the first disc
    const fsi::surfaceSet& surfaces = objects->surfaces();
    for (label i = 0; i < surfaces.pointStart()[1]; ++i)
    {
        const vector r = surfaces.points()[i] - point(2, 2, 0.5);
        const vector v = vector(1, 0, 0) + (vector(0, 0, 0.5) ^ r);
        EXPECT_NEAR(mag(surfaces.velocities()[i] - v), 0, 1e-12);
    }

    objects->groups()[0].positions().array() += 0.25;
    objects->updateSurfaces();
    EXPECT_NEAR(objects->surfaces().centroid(2).x(), 8.25, 1e-12);
    EXPECT_EQ(objects->surfaces().bounds(2).min().z(), 0.5);
}


TEST(Population, layoutsAreConvertedThereAndBack)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());
    const label n = objects->surfaces().points().size();

    vectorField values(n);
    forAll(values, i)
    {
        values[i] = vector(i, -2*i, 7);
    }
    List<Eigen::MatrixXd> groupNodal;
    objects->layout().toGroups(values, groupNodal);

    const label nBoundary = objects->shape(0).nBoundaryNodes();
    const label start = objects->surfaces().pointStart()[1];
    EXPECT_EQ(groupNodal[0](2, 2), start + 2);
    EXPECT_EQ(groupNodal[0](2, 3), -2*(start + 2));
    EXPECT_EQ
    (
        groupNodal[0].bottomRows(objects->shape(0).nNodes() - nBoundary)
           .cwiseAbs().maxCoeff(),
        0
    );

    vectorField back;
    objects->layout().toSurface(groupNodal, back);
    ASSERT_EQ(back.size(), n);
    forAll(back, i)
    {
        EXPECT_EQ(back[i], vector(i, -2*i, 0));
    }
}


TEST(Population, boundaryLayoutHasTheBoundaryRows)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());
    const fsi::nodeLayout& layout = objects->layout();
    EXPECT_EQ(layout.nSurface(), objects->surfaces().points().size());
    EXPECT_EQ(layout.nNodes(), objects->nNodes());

    vectorField values(layout.nSurface());
    forAll(values, i)
    {
        values[i] = vector(3*i, 1 - i, 0);
    }
    List<Eigen::MatrixXd> groupNodal, boundary;
    layout.toGroups(values, groupNodal);
    layout.toBoundary(values, boundary);
    forAll(boundary, groupi)
    {
        const label nB = objects->shape(groupi).nBoundaryNodes();
        EXPECT_EQ(boundary[groupi].rows(), nB);
        EXPECT_EQ(boundary[groupi], groupNodal[groupi].topRows(nB));
        EXPECT_EQ(boundary[groupi], layout.boundaryOf(groupNodal)[groupi]);
    }
    vectorField back;
    layout.toSurface(boundary, back);
    EXPECT_EQ(back, values);
}


TEST(Population, velocitiesHaveOneOwner)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());
    fsi::nodeVelocities v(objects->layout());
    EXPECT_EQ(max(mag(v.surface())), 0);

    // The surface's view follows each change
    v.change()[0].setConstant(2);
    EXPECT_EQ(v.surface()[0], vector(2, 2, 0));
    v.change()[0](0, 1) = 5;
    EXPECT_EQ(v.surface()[0], vector(2, 5, 0));
    v.reset();
    EXPECT_EQ(max(mag(v.surface())), 0);
}


TEST(Population, removingKeepsTheOthers)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());

    objects->remove(labelList({0, 3}));
    EXPECT_EQ(ids(*objects), labelList({1, 2, 4}));
    EXPECT_NEAR(objects->surfaces().centroid(0).x(), 5, 1e-12);
    EXPECT_NEAR(objects->surfaces().centroid(1).x(), 8, 1e-12);
    EXPECT_NEAR(objects->surfaces().centroid(2).y(), 6, 1e-12);
    EXPECT_EQ(objects->findObject(4), 2);

    const label id = objects->append
    (
        0, point(5, 9, 0), tensor::I, vector::zero, vector::zero
    );
    EXPECT_EQ(id, 5);
    EXPECT_EQ(ids(*objects), labelList({1, 2, 5, 4}));
    EXPECT_NEAR(objects->surfaces().centroid(2).y(), 9, 1e-12);
}


TEST(Population, refusesTwoShapesOfOneName)
{
    NEEDS_THROWN_ERRORS
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());
    autoPtr<fsi::shapeTemplate> again
    (
        fsi::newShapeTemplate
        (
            "disc",
            someObjects::dict
            (
                "shape { type circle; radius 1; }"
                "material { density 2; E 10; }"
            ),
            0.4, 1, 2
        ).release()
    );
    EXPECT_NE
    (
        someObjects::errorText
        ([&]() { objects->addShape(again, dictionary()); }).find("disc"),
        std::string::npos
    );
}


TEST(Population, restartIsExactInAscii)
{
    testRoundTrip("ascii");
}


TEST(Population, restartIsExactInBinary)
{
    testRoundTrip("binary");
}


TEST(Population, saysWhatToRunWhereThereIsNone)
{
    NEEDS_THROWN_ERRORS
    boxMesh box(labelVector(8, 8, 1), 2);
    EXPECT_NE
    (
        someObjects::errorText([&]() { population objects(box.time()); })
           .find("Run seedObjects"),
        std::string::npos
    );
}


// ************************************************************************* //
