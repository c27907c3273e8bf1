// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidForce.H"
#include "errorOf.H"
#include "OStringStream.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef IOstream::streamFormat format;

const string rubber
(
    "density 1000; E 1e4; springLaw { type Maxwell; viscosity 300; }"
);


//- Text that write() gives
template<class Type>
string written(const Type& object, const format fmt)
{
    OStringStream os(fmt);
    object.write(os);
    return os.str();
}


//- Some copies on their way
std::unique_ptr<bodyGroup> moving(const shapeTemplate& shape)
{
    auto group = groupOf(shape);
    for (label i = 0; i < 3; ++i)
    {
        const vector omega(0, 0, i);
        const vector v(1, 0, 0);
        group->append(point(i, 1, 0), tensor::I, v, omega, 10 + i);
    }
    run(*group, unevenForce(*group, 20), 5e-3, 5);
    return group;
}


//- Same number of copies and same bits?
void expectSame(const bodyGroup& a, const bodyGroup& b)
{
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE(a.objectIds() == b.objectIds());
    EXPECT_EQ((a.positions() - b.positions()).cwiseAbs().maxCoeff(), 0);
    EXPECT_EQ((a.velocities() - b.velocities()).cwiseAbs().maxCoeff(), 0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(state, roundTripKeepsEveryBit)
{
    auto shape = disc(rubber);
    auto group = moving(*shape);
    for (const format fmt : {IOstream::ASCII, IOstream::BINARY})
    {
        auto restored = groupOf(*shape);
        IStringStream is(written(*group, fmt), fmt);
        restored->read(dictionary(is));
        expectSame(*group, *restored);

        // And they go on alike: the state of the springs came with them
        auto original = groupOf(*shape);
        IStringStream again(written(*group, fmt), fmt);
        original->read(dictionary(again));
        const Eigen::MatrixXd force = unevenForce(*group, 20);
        run(*original, force, 5e-3, 3);
        run(*restored, force, 5e-3, 3);
        expectSame(*original, *restored);
        auto uninterrupted = moving(*shape);
        run(*uninterrupted, force, 5e-3, 3);
        expectSame(*uninterrupted, *restored);
    }
}


TEST(state, templateRoundTripKeepsEveryBit)
{
    auto shape = disc(rubber, "iterations 7;");
    for (const format fmt : {IOstream::ASCII, IOstream::BINARY})
    {
        IStringStream is(written(*shape, fmt), fmt);
        const shapeTemplate restored{dictionary(is)};

        EXPECT_EQ(restored.name(), shape->name());
        EXPECT_TRUE(restored.points() == shape->points());
        EXPECT_TRUE(restored.faces() == shape->faces());
        EXPECT_TRUE(restored.elements() == shape->elements());
        EXPECT_TRUE(restored.springs() == shape->springs());
        EXPECT_TRUE(restored.restLengths() == shape->restLengths());
        EXPECT_TRUE(restored.springConstants() == shape->springConstants());
        EXPECT_TRUE(restored.nodeMasses() == shape->nodeMasses());
        EXPECT_EQ(restored.mass(), shape->mass());
        EXPECT_EQ(restored.admm().iterations, 7);
        EXPECT_EQ(restored.law().type(), "Maxwell");

        auto a = moving(*shape);
        auto b = moving(restored);
        expectSame(*a, *b);
    }
}


TEST(state, removedCopyLeavesTheOthers)
{
    auto shape = disc(rubber);
    auto group = moving(*shape);
    const Eigen::MatrixXd positions = group->positions();
    group->remove(labelList({1}));

    ASSERT_EQ(group->size(), 2);
    EXPECT_TRUE(group->objectIds() == labelList({10, 12}));
    EXPECT_EQ(group->positions().leftCols(2), positions.leftCols(2));
    EXPECT_EQ(group->positions().rightCols(2), positions.rightCols(2));

    // The springs of the last copy remember its own past
    auto whole = moving(*shape);
    const Eigen::MatrixXd force = unevenForce(*whole, 20);
    run(*whole, force, 5e-3, 3);
    Eigen::MatrixXd kept(force.rows(), 4);
    kept << force.leftCols(2), force.rightCols(2);
    run(*group, kept, 5e-3, 3);
    EXPECT_EQ(group->positions().rightCols(2), whole->positions().rightCols(2));
}


TEST(state, meanLoadFollowsItsCopy)
{
    auto shape = disc(rubber);
    auto group = moving(*shape);
    const Eigen::MatrixXd force = unevenForce(*group, 20);
    const label nBoundary = shape->nBoundaryNodes();

    // The part of a boundary load that deforms, without net force and torque
    group->prepareResponse(5e-3);
    const auto deforming = [&](const Eigen::MatrixXd& load)
    {
        Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(load.rows(), load.cols());
        addRigidForce(*group, load.topRows(nBoundary), rigid);
        Eigen::MatrixXd result = -rigid;
        result.topRows(nBoundary) += load.topRows(nBoundary);
        return result;
    };

    // Nothing of a load is lost, and a steady one ends in the mean
    group->keepLoad(force);
    Eigen::MatrixXd load = force;
    Eigen::MatrixXd rest = group->splitLoad(load);
    EXPECT_LT((load + rest - force).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((load - 0.25*deforming(force)).norm(), 1e-12*force.norm());
    EXPECT_LT(load.colwise().sum().norm(), 1e-12*force.norm());
    for (label i = 0; i < 100; ++i)
    {
        load = force;
        rest = group->splitLoad(load);
    }
    EXPECT_LT((load - deforming(force)).norm(), 1e-10*force.norm());

    const Eigen::MatrixXd next = 2*unevenForce(*group, 10);
    group->keepLoad(next);
    const Eigen::MatrixXd mean = 0.75*deforming(force) + 0.25*deforming(next);

    for (const format fmt : {IOstream::ASCII, IOstream::BINARY})
    {
        auto restored = groupOf(*shape);
        IStringStream is(written(*group, fmt), fmt);
        restored->read(dictionary(is));
        restored->remove(labelList({1}));
        restored->append(point(5, 1, 0), tensor::I, Zero, Zero, 20);

        restored->prepareResponse(5e-3);
        Eigen::MatrixXd found = Eigen::MatrixXd::Zero(load.rows(), load.cols());
        restored->splitLoad(found);
        const scalar small = 1e-12*mean.norm();
        EXPECT_LT((found.leftCols(2) - mean.leftCols(2)).norm(), small);
        EXPECT_LT((found.middleCols(2, 2) - mean.rightCols(2)).norm(), small);
        EXPECT_EQ(found.rightCols(2).norm(), 0);
    }
}


TEST(state, ofAnotherShapeIsRefused)
{
    auto shape = disc(rubber);
    auto other = disc(rubber, "", 0.03);
    auto group = moving(*shape);
    auto restored = groupOf(*other);
    IStringStream is(written(*group, IOstream::ASCII));
    EXPECT_THROW(restored->read(dictionary(is)), Foam::IOerror);
}


TEST(state, ofFacesThatAreTurnedOverIsRefused)
{
    const string text(written(*disc(rubber), IOstream::ASCII));
    IStringStream first(text), second(text);
    const dictionary whole(first);
    EXPECT_NO_THROW(shapeTemplate{whole});

    // A list that has been read is gone from its dictionary
    dictionary dict(second);
    labelList faces(readEntry<labelList>(dict, "faces"));
    ASSERT_GT(faces.size(), 3);
    for (label i = 0; i < faces.size(); i += 3)
    {
        Swap(faces[i], faces[i + 1]);
    }
    dict.set("faces", faces);
    EXPECT_THROW(shapeTemplate{dict}, Foam::IOerror);
}


TEST(state, placementIsRigid)
{
    auto shape = disc("density 1000; E 1e4;");
    auto group = groupOf(*shape);
    const scalar angle = 0.3;
    const tensor turn
    (
        std::cos(angle), -std::sin(angle), 0,
        std::sin(angle), std::cos(angle), 0,
        0, 0, 1
    );
    group->append(point(3, 4, 0), turn, vector(1, 2, 0), vector(0, 0, 6), 5);

    EXPECT_NEAR(group->volume(0), shape->referenceVolume(), 1e-14);
    EXPECT_NEAR(group->angularVelocity(0).z(), 6, 1e-10);
    EXPECT_LT(mag(group->centroid(0) - point(3, 4, 0)), 1e-3);
    EXPECT_LT(mag(group->velocity(0) - vector(1, 2, 0)), 1e-2);
    EXPECT_LT(group->elasticEnergy(), 1e-20);
    EXPECT_EQ(group->objectIds()[0], 5);
}


// ************************************************************************* //
