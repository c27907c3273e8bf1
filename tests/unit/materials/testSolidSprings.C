// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Springs of bodies in 3D: moduli that they show, and their laws.

\*---------------------------------------------------------------------------*/

#include "patchTest.H"
#include "openfoamVersion.H"
#include "samples/solidSamples.H"
#include "springCalibration.H"

#include <gtest/gtest.h>

using namespace solidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4, side = 0.1;
const string springs("type elastic; density 1000; E 1e4; ");


//- Compliance of a body, from the patch test
Eigen::MatrixXd compliance(const shapeTemplate& shape)
{
    return patchTest::compliances
    (
        shape.mesh(),
        shape.springs(),
        shape.springConstants(),
        shape.elementTerm(),
        1,
        labelListList(1, identityList(shape.elements().size()))
    )[0];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solidSprings, uniformStrainHasVanGeldersEnergy)
{
    // (E/5) ((tr e)^2 + 2 e:e) over all directions; for the edges that a mesh
    // has, (E/2) sum V_t (n.e.n)^2
    const auto shape = solidOf
    (
        unevenCentredCube(3, side),
        side,
        springs + "areaStiffness 0; calibration vanGelder;"
    );
    copies body(*shape);
    Eigen::Matrix3d strain;
    strain << 2, 1, -1, 1, -1, 0.5, -1, 0.5, 3;
    strain *= 1e-6;
    scalar expected = 0;
    forAll(shape->elements(), elementi)
    {
        const bodyElement& e = shape->elements()[elementi];
        for (label i = 0; i < 4; ++i)
        {
            for (label j = 0; j < i; ++j)
            {
                const vector d = shape->points()[e[i]] - shape->points()[e[j]];
                const Eigen::Vector3d n
                (
                    Eigen::Vector3d(d.x(), d.y(), d.z()).normalized()
                );
                expected += 0.5*E*shape->elementTerm().volumes()[elementi]
                   *sqr(n.dot(strain*n));
            }
        }
    }
    body.deform(Eigen::Matrix3d::Identity() + strain);
    EXPECT_NEAR(body.energy(), expected, 1e-4*expected);
}


TEST(solidSprings, patchTestFindsTheModuliOfElements)
{
    // Volume terms alone beside springs that are as stiff as nothing: the bulk
    // modulus under equal stresses is kappa/2
    const auto shape = solidOf
    (
        unevenCentredCube(3, side),
        side,
        springs + "areaStiffness 1e5; strain element; calibration vanGelder;"
    );
    const scalarField weak(1e-3*shape->springConstants());
    const Eigen::MatrixXd S = patchTest::compliances
    (
        shape->mesh(),
        shape->springs(),
        weak,
        shape->elementTerm(),
        1,
        labelListList(1, identityList(shape->elements().size()))
    )[0];
    EXPECT_NEAR(1/S.topLeftCorner(3, 3).sum(), 0.5e5, 0.01*0.5e5);
    EXPECT_LT((S - S.transpose()).norm(), 1e-6*S.norm());
}


TEST(solidSprings, bodiesShowYoungsModulusInAllDirections)
{
    for (const string area : {"areaStiffness 0;", "", "areaStiffness 1e6;"})
    {
        const auto shape = solidOf
        (
            unevenCentredCube(5, side), side, springs + area
        );
        const Eigen::MatrixXd S = compliance(*shape);
        scalar least = GREAT, most = 0;
        for (label i = 0; i < 200; ++i)
        {
            const vector n(std::sin(1.0*i), std::cos(2.3*i), std::sin(0.7*i*i));
            const scalar shown = 1/patchTest::modulusInverse(S, n/mag(n));
            least = min(least, shown);
            most = max(most, shown);
        }
        EXPECT_GT(least, 0.98*E) << area;
        EXPECT_LT(most, 1.02*E) << area;

        // 2 G (1 + nu) = E, with nu from the closed form (3.38)
        const scalar kappa = shape->areaStiffness();
        const scalar mu =
            0.4*E*springCalibration::regularFactor(E, kappa, 3);
        const scalar K = 5*mu/3 + 0.5*kappa;
        EXPECT_NEAR(9*K*mu/(3*K + mu), E, 1e-9*E);
        for (label i = 3; i < 6; ++i)
        {
            EXPECT_NEAR(1/S(i, i), mu, 0.05*mu) << area;
        }
    }
}


TEST(solidSprings, uncalibratedBodiesAreSofter)
{
    const auto shape = solidOf
    (
        unevenCentredCube(5, side),
        side,
        springs + "areaStiffness 0; calibration vanGelder;"
    );
    const Eigen::MatrixXd S = compliance(*shape);
    const scalar shown = 1/patchTest::modulusInverse(S, vector(0, 0, 1));
    EXPECT_LT(shown, 0.99*E);
    EXPECT_GT(shown, 0.8*E);
}


// Creep under constant stress and relaxation at constant strain, both with the
// time viscosity/E

TEST(solidSprings, lawsCreepAndRelax)
{
    const scalar tau = 0.1, stress = 1e-3*E;
    Eigen::Matrix3d sigma = Eigen::Matrix3d::Zero();
    sigma(0, 0) = stress;
    const string light
    (
        "type elastic; density 1e-4; E 1e4; areaStiffness 0; "
    );
    const string admm("iterations 300; tolerance 1e-9;");
    const label nSteps = 200;
    const auto strainAfter = [&](const string& law)
    {
        const auto shape =
            solidOf(unevenCentredCube(3, side), side, light + law, admm);
        copies body(*shape);
        body.run(traction(*shape, sigma), tau/nSteps, nSteps);
        return meanStrain(body)(0, 0);
    };
    const scalar elastic = strainAfter("");
    EXPECT_NEAR(elastic, stress/E, 0.01*stress/E);

    // E tau = 1000 Pa s
    const scalar voigt =
        strainAfter("springLaw { type KelvinVoigt; viscosity 1e3; }");
    EXPECT_NEAR(voigt, elastic*(1 - std::exp(-1)), 0.01*elastic);
    const scalar maxwell =
        strainAfter("springLaw { type Maxwell; viscosity 1e3; }");
    EXPECT_NEAR(maxwell, 2*elastic, 0.02*elastic);
}


// ************************************************************************* //
