// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "mathematicalConstants.H"
#include "softDiscs.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar spacing = 0.01, h = 0.015;


//- Two discs of radius 0.1, E = 10 Pa and density 1 kg/m3 that approach with
//  0.2 m/s each: offset of their paths, angle and velocity of the frame
struct collision
:
    public softDiscs
{
    scalar energyRatio = 0, gap = GREAT, contactTime = 0;
    scalar momentumError = 0, angularError = 0, volumeError = 0;
    scalar restitution;

    collision
    (
        const scalar offset,
        const scalar angle,
        const vector& frame,
        const scalar courant,
        const std::string& lawDict = "tolerance 1e-10;"
    )
    :
        softDiscs
        (
            "shape { type circle; radius 0.1; } material { density 1; E 10; }",
            spacing
        )
    {
        const vector along(std::cos(angle), std::sin(angle), 0);
        const vector across(-along.y(), along.x(), 0);
        const vector x(-0.13*along + 0.5*offset*across);
        add(x, 0.2*along + frame, angle);
        add(-x, -0.2*along + frame, angle + constant::mathematical::pi);

        contact law
        (
            dictionary
            (
                IStringStream("range 2; law {" + lawDict + "}")()
            ),
            2, h, 50
        );
        run(law, courant*h/0.2, frame);
    }

    void run(contact& law, const scalar dt, const vector& frame)
    {
        const vector p(momentum());
        const scalar l = angularMomentum();
        const scalar centre =
            centreEnergy() - group.mass()*magSqr(frame);
        const scalar start = energy();
        const scalar volume = group.volume(0);

        for (label i = 0; i*dt < 1; ++i)
        {
            const scalar before = energy();
            advance(law, dt);
            energyRatio = max
            (
                energyRatio, (before + statistics.potentialEnergy)/start
            );
            gap = min(gap, statistics.smallestGap);
            contactTime += dt*statistics.contacts;
            momentumError = max(momentumError, mag(momentum() - p)/mag(start));
            angularError = max(angularError, mag(angularMomentum() - l));
            volumeError = max(volumeError, mag(group.volume(0)/volume - 1));
        }
        restitution = std::sqrt
        (
            (centreEnergy() - group.mass()*magSqr(frame))/centre
        );
    }
};


//- The response that contact uses is the group's
void expectGroupResponse(softDiscs& c)
{
    const scalar dt = 0.013;
    c.group.prepareResponse(dt);
    c.setSurfaces(c.group.velocities());
    c.surfaces.velocities() = Zero;
    c.bodies.reset(c.surfaces);
    c.response.setNodes(c.surfaces, c.group.objectIds(), c.bodies);
    c.response.setResponse
    (
        c.surfaces, c.group.objectIds(), false, c.bodies
    );

    const label pairi = 0;
    List<contactPair> pairs(1);
    contactPair& pair = pairs[pairi];
    pair.node = 5;
    pair.face = 80;
    pair.wall = -1;
    pair.other = 1;
    pair.weights = FixedList<scalar, 3>({0.3, 0.7, 0});
    pair.normal = vector(0.6, -0.8, 0);

    contactResponse response;
    response.reset(c.surfaces, c.surfaces.velocities(), c.bodies, pairs);
    response.addImpulse(pairi, 0.02*dt);

    const label nB = c.shape.nBoundaryNodes();
    const surfaceFace& f = c.surfaces.faces()[80];
    Eigen::MatrixXd force(Eigen::MatrixXd::Zero(nB, 4)), v;
    for (direction d = 0; d < 2; ++d)
    {
        force(5, d) = 0.02*pair.normal[d];
        force(f[0] - nB, 2 + d) = -0.02*0.3*pair.normal[d];
        force(f[1] - nB, 2 + d) = -0.02*0.7*pair.normal[d];
    }
    c.group.response().respondBoundary(force, v);

    scalar expected = 0;
    for (direction d = 0; d < 2; ++d)
    {
        expected += pair.normal[d]*
        (
            v(5, d) - 0.3*v(f[0] - nB, 2 + d) - 0.7*v(f[1] - nB, 2 + d)
        );
    }
    ASSERT_GT(expected, 0);
    EXPECT_NEAR(response.normalVelocity(pairi)/expected, 1, 1e-9);
    EXPECT_NEAR(response.compliance(pairi)*0.02*dt/expected, 1, 1e-9);
}

} // End anonymous namespace


TEST(ContactSoft, responseIsThatOfTheGroup)
{
    collision c(0.05, 0.3, Zero, 0.5);
    expectGroupResponse(c);
}


TEST(ContactSoft, headOnAndOblique)
{
    for (const scalar offset : {0.0, 0.1})
    {
        for (const scalar courant : {0.02, 0.1, 0.5})
        {
            const collision c(offset, 0, Zero, courant);
            EXPECT_LT(c.energyRatio, 1.001);
            EXPECT_LT(c.momentumError, 1e-12);
            EXPECT_LT(c.angularError, 1e-13);
            EXPECT_LT(c.volumeError, 1e-10);
            EXPECT_GT(c.gap, 0.5*h);
            EXPECT_EQ(c.statistics.contacts, 0) << "they stick";
            if (courant < 0.05)
            {
                EXPECT_GT(c.restitution, 0.85);
                EXPECT_LT(c.restitution, 1);

                // 2 R/c_p times 2 to 4, c_p = sqrt(E/rho/(1 - nu^2))
                EXPECT_GT(c.contactTime, 2*0.06);
                EXPECT_LT(c.contactTime, 4*0.06);
            }
            std::cout
                << "offset " << offset << " Courant " << courant << ": e "
                << c.restitution << " gap/h " << c.gap/h << " time "
                << c.contactTime << std::endl;
        }
    }
}


TEST(ContactSoft, movingFrame)
{
    const collision c(0.05, 0, Zero, 0.1);
    const collision moving(0.05, 0, vector(0.3, -0.4, 0), 0.1);
    EXPECT_NEAR(moving.restitution, c.restitution, 1e-8);
    EXPECT_NEAR(moving.gap, c.gap, 1e-8*c.gap);
}


TEST(ContactSoft, turnedFrame)
{
    const collision c(0.05, 0, Zero, 0.1);
    const collision turned
    (
        0.05, constant::mathematical::pi/6, Zero, 0.1
    );
    EXPECT_NEAR(turned.restitution, c.restitution, 0.01*c.restitution);
}


TEST(ContactSoft, mirrorImages)
{
    // The second disc is the first turned by half a turn
    const collision c(0.05, 0, Zero, 0.1);
    const auto& x = c.group.positions();
    const scalar difference =
        (x.leftCols(2) + x.rightCols(2)).cwiseAbs().maxCoeff();
    EXPECT_LT(difference, 1e-10*0.1);
}


TEST(ContactSoft, restitutionTakesEnergy)
{
    const collision c(0, 0, Zero, 0.05);
    const collision damped
    (
        0, 0, Zero, 0.05, "tolerance 1e-10; restitution 0.3;"
    );
    EXPECT_LT(damped.restitution, 0.95*c.restitution);
    EXPECT_EQ(damped.statistics.contacts, 0);
}


// ************************************************************************* //
