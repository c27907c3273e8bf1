// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/equilibrium.H"
#include "meshGrading.H"
#include "samples/newShapeTemplate.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4;


//- Disc 40 node spacings across with the entries of `mesh`
std::unique_ptr<shapeTemplate> large(const string& grading)
{
    return newShapeTemplate
    (
        "disc",
        dictionaryOf
        (
            "shape { type circle; radius 0.1; } mesh { " + grading
          + " } material { density 1; E 1e4; }"
        ),
        0.005,
        1.0,
        2
    );
}


//- Radial displacement under the radial traction 0.001 E cos(n angle), as the
//  amplitude of the same harmonic over the radius
scalar lobes(const shapeTemplate& shape, const label n)
{
    auto group = groupOf(shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(shape.nNodes(), 2);
    const label nBoundary = shape.nBoundaryNodes();
    const scalar side =
        mag(shape.points()[1] - shape.points()[0])*shape.thickness();
    for (label i = 0; i < nBoundary; ++i)
    {
        const vector normal = shape.points()[i]/mag(shape.points()[i]);
        const scalar angle = std::atan2(normal.y(), normal.x());
        const scalar traction = 1e-3*E*std::cos(n*angle);
        force(i, 0) = traction*side*normal.x();
        force(i, 1) = traction*side*normal.y();
    }
    equilibrate(*group, force, 1);

    scalar amplitude = 0;
    for (label i = 0; i < nBoundary; ++i)
    {
        const point& p = shape.points()[i];
        const scalar radial =
            (group->positions()(i, 0)*p.x() + group->positions()(i, 1)*p.y())
           /mag(p)
          - mag(p);
        amplitude += radial*std::cos(n*std::atan2(p.y(), p.x()));
    }
    return 2*amplitude/nBoundary/0.1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(grading, discHasTheModulusInAllDirections)
{
    auto shape = large("");
    const scalar stress = 1e-3*E;
    auto strainUnder = [&](scalar xx, scalar yy)
    {
        auto group = groupOf(*shape);
        group->append(Zero, tensor::I, Zero, Zero, 0);
        equilibrate(*group, traction(*shape, xx, yy, 0), 1);
        return meanStrain(*group);
    };
    EXPECT_NEAR(stress/strainUnder(stress, 0)[0], E, 0.01*E);
    EXPECT_NEAR(stress/strainUnder(0, stress)[1], E, 0.01*E);
}


TEST(grading, discDeformsAsAnEvenOne)
{
    auto even = large("growthRate 0;");
    auto graded = large("");
    EXPECT_LT(graded->nNodes(), 0.75*even->nNodes());
    for (const label n : {2, 3, 6})
    {
        const scalar expected = lobes(*even, n);
        const scalar found = lobes(*graded, n);
        EXPECT_NEAR(found, expected, 0.02*expected) << n << " lobes";
        std::cout
            << n << " lobes: " << found/expected << " of the displacement with "
            << even->nNodes() << " even nodes, " << graded->nNodes()
            << std::endl;
    }
}


TEST(grading, badEntriesAreRefused)
{
    for (const string text : {"growthRate -1;", "growthRate 2;", "layers 3;"})
    {
        EXPECT_THROW(meshGrading(dictionaryOf(text)), Foam::IOerror) << text;
    }
}


// ************************************************************************* //
