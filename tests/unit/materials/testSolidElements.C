// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Elements of bodies in 3D: energies, forces, the moduli they show.

\*---------------------------------------------------------------------------*/

#include "shearTerm.H"
#include "samples/solidSamples.H"

#include <gtest/gtest.h>

using namespace solidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4;
const string neoHookean("density 1000; E 1e4; ");
const string springs("type elastic; density 1000; E 1e4; ");
const List<string> materials
({
    neoHookean,
    neoHookean + "strain element;",
    neoHookean + "strain smoothed;",
    springs,
    springs + "strain element;"
});


//- A turn that is about no axis of the mesh
Eigen::Matrix3d turn(const scalar angle)
{
    return Eigen::AngleAxis<scalar>
    (
        angle, Eigen::Vector3d(1, -2, 0.7).normalized()
    ).toRotationMatrix();
}


//- Strain under a stress xx and under a shear stress, in a body of E: the
//  stretch along and across, and twice the shear
Eigen::Vector3d compliances(const shapeTemplate& shape, const scalar size)
{
    const scalar stress = 1e-4*E;
    Eigen::Matrix3d sigma = Eigen::Matrix3d::Zero();
    sigma(0, 0) = stress;
    copies stretched(shape);
    equilibrate(stretched, traction(shape, sigma), size);
    const Eigen::Matrix3d along = meanStrain(stretched);

    sigma.setZero();
    sigma(1, 2) = sigma(2, 1) = stress;
    copies sheared(shape);
    equilibrate(sheared, traction(shape, sigma), size);
    return Eigen::Vector3d
    (
        along(0, 0),
        0.5*(along(1, 1) + along(2, 2)),
        2*meanStrain(sheared)(1, 2)
    )/stress;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solidElements, uniformStrainHasTheEnergyOfTheMaterial)
{
    Eigen::Matrix3d F;
    F << 1.2, 0.3, -0.1, 0.1, 0.9, 0.2, 0, -0.2, 1.1;
    const scalar K = 5*E, mu = 3*K*E/(9*K - E), J = F.determinant();
    const scalar density =
        0.5*mu*(F.squaredNorm() - 3) - mu*(J - 1)
      + 0.5*(K + mu/3)*sqr(J - 1);
    for (const string strain : {"element", "nodalVolume", "smoothed"})
    {
        const auto shape = solidOf
        (
            unevenCube(3, 0.1), 0.1, neoHookean + "strain " + strain + ";"
        );
        copies body(*shape);
        body.deform(F);
        const scalar expected = density*shape->referenceVolume();
        EXPECT_NEAR(body.energy(), expected, 1e-12*expected) << strain;

        // A uniform stress has no force inside
        Eigen::MatrixXd force = body.none();
        body.energy(&force);
        const label n = shape->nBoundaryNodes();
        EXPECT_LT
        (
            force.bottomRows(shape->nNodes() - n).norm(), 1e-12*force.norm()
        );
        EXPECT_GT(force.norm(), 0.1*E*0.01);
    }
}


TEST(solidElements, restHasNoStressAndTurnsNoEnergy)
{
    for (const string& material : materials)
    {
        const auto shape = solidOf(unevenCentredCube(3, 0.1), 0.1, material);
        copies body(*shape);
        Eigen::MatrixXd force = body.none();
        EXPECT_EQ(body.energy(&force), 0);
        EXPECT_EQ(force.norm(), 0);

        body.deform(turn(1.1));
        body.energy(&force);
        EXPECT_LT(force.norm(), 1e-13*E*0.1);

        // Turned after a deformation
        copies straight(*shape), turned(*shape);
        crumple(straight, 0.01);
        crumple(turned, 0.01);
        turned.deform(turn(0.8));
        EXPECT_NEAR
        (
            turned.energy(), straight.energy(), 1e-12*straight.energy()
        );
        EXPECT_GT(straight.energy(), 0);
    }
}


TEST(solidElements, forceIsTheGradientOfTheEnergy)
{
    for (const string& material : materials)
    {
        const auto shape = solidOf(unevenCentredCube(2, 0.1), 0.1, material);
        copies body(*shape);
        crumple(body, 0.02);
        Eigen::MatrixXd force = body.none();
        body.energy(&force);
        EXPECT_LT(momenta(body.x, force).norm(), 1e-12*force.norm());
        const scalar step = 1e-7;
        for (label i = 0; i < body.x.size(); ++i)
        {
            scalar& x = body.x.data()[i];
            const scalar old = x;
            x = old + step;
            const scalar up = body.energy();
            x = old - step;
            const scalar down = body.energy();
            x = old;
            EXPECT_NEAR
            (
                force.data()[i], (down - up)/(2*step), 1e-7*force.norm()
            ) << material;
        }
    }
}


TEST(solidElements, localStepOfAdmmIsTheMinimum)
{
    typedef laneArray<1> number;
    Eigen::Matrix3d start;
    start << 1.3, 0.2, -0.1, 0.1, 0.8, 0.3, 0, -0.2, 0.7;
    for (const scalar shearPart : {0.0, 0.07})
    {
        // From F = 1 with y in u; each call goes on from the last z
        const scalar ratio = 0.5;
        number F[9], u[9], z[9];
        for (int i = 0; i < 9; ++i)
        {
            F[i] = i % 4 ? 0 : 1;
            u[i] = 0;
        }
        volumeTerm::toLocalStep<3>(F, u, ratio, shearPart);
        for (int i = 0; i < 9; ++i)
        {
            EXPECT_EQ(u[i][0], 0);
            u[i] = 0;
        }
        for (label call = 0; call < 15; ++call)
        {
            for (int i = 0; i < 9; ++i)
            {
                // F + u stays y
                F[i] = start(i/3, i % 3) - u[i][0];
            }
            volumeTerm::toLocalStep<3>(F, u, ratio, shearPart);
        }
        for (int i = 0; i < 9; ++i)
        {
            z[i] = start(i/3, i % 3) - u[i][0];
        }
        volumeTerm::toGradient<3>(z, shearPart);
        for (int i = 0; i < 9; ++i)
        {
            EXPECT_NEAR(z[i][0], ratio*u[i][0], 1e-10);
        }
    }
}


TEST(solidElements, neoHookeanBodiesShowTheirModuli)
{
    for (const scalar ratio : {2.0, 10.0, 100.0})
    {
        const scalar kappa = ratio*E;
        const scalar K = 0.5*kappa, mu = 3*K*E/(9*K - E);
        for (const string strain : {"element", "nodalVolume", "smoothed"})
        {
            const auto shape = solidOf
            (
                unevenCube(4, 0.1),
                0.1,
                neoHookean + "areaStiffness " + name(kappa)
              + "; strain " + strain + ";",
                "iterations 4000; tolerance 1e-10;"
            );
            const Eigen::Vector3d found = E*compliances(*shape, 0.4);
            EXPECT_NEAR(found[0], 1, 2e-3) << strain << ratio;
            EXPECT_NEAR(found[1], -0.5*(1 - E/(3*K)), 2e-3) << strain << ratio;
            EXPECT_NEAR(found[2], E/mu, 4e-3) << strain << ratio;
        }
    }
}


// ************************************************************************* //
