// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidSamples.H"

#include <gtest/gtest.h>

using namespace rigidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const vector lengths(0.3, 0.2, 0.1);

//- Moments of inertia of the block about its axes, 1000 kg/m3
vector inertia()
{
    const scalar m = 1000*lengths.x()*lengths.y()*lengths.z();
    const vector s(cmptMultiply(lengths, lengths));
    return m/12*vector(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
}


//- Angular velocity in the body's axes of the free block after a time, by
//  Euler's equations and the classical Runge-Kutta method
vector topAfter(vector omega, const scalar time)
{
    const vector I(inertia());
    const auto rate = [&](const vector& w)
    {
        const vector L(cmptMultiply(I, w));
        return cmptDivide(L ^ w, I);
    };
    const label n = 20000;
    const scalar dt = time/n;
    for (label i = 0; i < n; ++i)
    {
        const vector a(rate(omega));
        const vector b(rate(omega + 0.5*dt*a));
        const vector c(rate(omega + 0.5*dt*b));
        const vector d(rate(omega + dt*c));
        omega += dt/6*(a + 2*b + 2*c + d);
    }
    return omega;
}


//- Error of the top's angular velocity after a second in steps of dt
scalar topError(const scalar dt)
{
    auto shape = rigidShape(blockSurface(lengths, 3), 3);
    auto group = bodyGroup::New(*shape, dictionary());
    const vector omega(0.3, 5, 0.4);
    group->append(Zero, tensor::I, Zero, omega, 0);
    const Eigen::MatrixXd none(Eigen::MatrixXd::Zero(shape->nNodes(), 3));
    const label n = label(std::round(1/dt));

    for (label i = 0; i < n; ++i)
    {
        advance(*group, none, dt);
    }
    const auto side = [&](const label to)
    {
        const vector d
        (
            at(group->positions(), 3, to) - at(group->positions(), 3, 0)
        );
        return d/mag(d);
    };
    const vector spin(group->angularVelocity(0));
    const vector inBody(side(1) & spin, side(2) & spin, side(4) & spin);
    return mag(inBody - topAfter(omega, 1));
}


//- Largest change of a distance between two nodes over the block's length
scalar distortion(const bodyGroup& group, const label nDims)
{
    scalar worst = 0;
    const pointField& X = group.shape().points();
    for (label copyi = 0; copyi < group.size(); ++copyi)
    {
        forAll(X, i)
        {
            for (label j = 0; j < i; ++j)
            {
                const scalar found = mag
                (
                    at(group.positions(), nDims, i, copyi)
                  - at(group.positions(), nDims, j, copyi)
                );
                worst = max(worst, mag(found - mag(X[i] - X[j])));
            }
        }
    }
    return worst/lengths.x();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(rigidBodies, haveMassAndInertiaOfTheirSurface)
{
    for (const direction nDims : {2, 3})
    {
        auto shape = rigidShape(blockSurface(lengths, nDims), nDims);
        const scalar depth = nDims == 2 ? 1 : lengths.z();
        const scalar m = 1000*lengths.x()*lengths.y()*depth;
        EXPECT_NEAR(shape->mass(), m, 1e-12*m);
        EXPECT_NEAR(sum(shape->nodeMasses()), m, 1e-12*m);

        auto group = bodyGroup::New(*shape, dictionary());
        const vector omega(nDims == 2 ? Zero : vector(1, 2, 0));
        const vector w(omega + vector(0, 0, 3));
        group->append(point(4, 5, 0), tensor::I, vector(1, 2, 0), w, 0);
        EXPECT_LT(mag(group->centroid(0) - point(4, 5, 0)), 1e-12);
        EXPECT_LT(mag(group->momentum(0) - m*vector(1, 2, 0)), 1e-12*m);
        EXPECT_LT(mag(group->angularVelocity(0) - w), 1e-12);
        const scalar z =
            m/12*(sqr(lengths.x()) + sqr(lengths.y()))*w.z();
        EXPECT_NEAR(group->angularMomentum(0).z(), z, 1e-12*z);
        if (nDims == 3)
        {
            EXPECT_NEAR
            (
                group->angularMomentum(0).y(), inertia().y()*w.y(), 1e-12*z
            );
        }
    }
}


TEST(rigidBodies, centreOfMassIsThatOfAnUnevenSurface)
{
    // Three quarters of a square: an L of area 3, centroid (5/6 5/6)
    shapeMesh mesh;
    const scalar x[6] = {0, 2, 2, 1, 1, 0}, y[6] = {0, 0, 1, 1, 2, 2};
    for (label i = 0; i < 6; ++i)
    {
        mesh.points.append(point(x[i], y[i], 0));
        surfaceFace face(-1);
        face[0] = i;
        face[1] = (i + 1) % 6;
        mesh.faces.append(face);
    }
    mesh.nBoundary = 6;
    auto shape = rigidShape(mesh, 2);
    auto group = bodyGroup::New(*shape, dictionary());
    group->append(Zero, tensor::I, Zero, vector(0, 0, 1), 0);
    EXPECT_NEAR(shape->referenceVolume(), 3, 1e-14);
    EXPECT_LT(mag(group->centroid(0) - point(5, 5, 0)/6), 1e-14);

    // Three unit squares: 3 (1/6) + sum of squared distances of their centres
    const scalar polar = 3.0/6 + sqr(1.0/3)*2 + 2*(sqr(2.0/3) + sqr(1.0/3));
    EXPECT_NEAR(group->angularMomentum(0).z(), 1000*polar, 1e-9);
}


TEST(rigidBodies, aTopKeepsItsMomentumAndItsShape)
{
    for (const direction nDims : {2, 3})
    {
        auto shape = rigidShape(blockSurface(lengths, nDims), nDims);
        auto group = bodyGroup::New(*shape, dictionary());
        const vector omega(nDims == 2 ? vector(0, 0, 7) : vector(0.5, 7, 0.3));
        group->append
        (
            point(1, 2, 0), tensor::I, vector(0.3, -0.2, 0), omega, 0
        );
        const vector momentum(group->momentum(0));
        const vector spin(group->angularMomentum(0));
        const scalar energy = group->kineticEnergy();
        const scalar volume = group->volume(0);
        const Eigen::MatrixXd none
        (
            Eigen::MatrixXd::Zero(shape->nNodes(), nDims)
        );
        scalar energyError = 0, shapeError = 0;
        for (label i = 0; i < 10000; ++i)
        {
            advance(*group, none, 1e-3);
            energyError =
                max(energyError, mag(group->kineticEnergy()/energy - 1));
            if (i % 100 == 99)
            {
                shapeError = max(shapeError, distortion(*group, nDims));
            }
        }
        EXPECT_LT(mag(group->momentum(0) - momentum), 1e-11*mag(momentum));
        // Positions are rounded at a distance of some m
        EXPECT_LT(mag(group->angularMomentum(0) - spin), 1e-10*mag(spin));
        EXPECT_LT(shapeError, 1e-13);
        EXPECT_NEAR(group->volume(0)/volume, 1, 1e-13);

        // (omega dt)^2
        EXPECT_LT(energyError, 5e-5);
    }
}


TEST(rigidBodies, theTopTumblesInSecondOrder)
{
    // About the middle axis, which is unstable
    const scalar coarse = topError(4e-3), fine = topError(2e-3);
    EXPECT_LT(fine, 0.05);
    EXPECT_NEAR(coarse/fine, 4, 0.4);
}


TEST(rigidBodies, followForcesAndTorques)
{
    for (const direction nDims : {2, 3})
    {
        auto shape = rigidShape(blockSurface(lengths, nDims), nDims);
        auto group = bodyGroup::New(*shape, dictionary());
        for (label i = 0; i < 2; ++i)
        {
            group->append(point(i, 0, 0), tensor::I, Zero, Zero, i);
        }

        // A force at a corner of the second
        Eigen::MatrixXd force
        (
            Eigen::MatrixXd::Zero(shape->nNodes(), 2*nDims)
        );
        const vector F(3, 2, nDims == 2 ? 0 : 4);
        for (label d = 0; d < nDims; ++d)
        {
            force(1, nDims + d) = F[d];
        }
        const scalar dt = 1e-3;
        const point corner(at(group->positions(), nDims, 1, 1));
        const vector torque((corner - point(1, 0, 0)) ^ F);
        group->prepareResponse(dt);
        Eigen::MatrixXd v, w;
        group->predict(0, dt, force, v);
        group->response().respond(force, w);
        EXPECT_LT((v - w).cwiseAbs().maxCoeff(), 1e-15);

        group->constrain(dt, v);
        group->move(dt, v);
        EXPECT_LT(mag(group->momentum(0)), 1e-15);
        EXPECT_LT(mag(group->momentum(1) - dt*F), 1e-13*mag(dt*F));
        EXPECT_LT
        (
            mag(group->angularMomentum(1) - dt*torque), 1e-11*mag(dt*torque)
        );
        EXPECT_LT(distortion(*group, nDims), 1e-14);
    }
}


TEST(rigidBodies, refuseToTurnTooFarInAStep)
{
    auto shape = rigidShape(blockSurface(lengths, 2), 2);
    auto group = bodyGroup::New(*shape, dictionary());
    group->append(Zero, tensor::I, Zero, vector(0, 0, 1500), 0);
    const Eigen::MatrixXd none(Eigen::MatrixXd::Zero(shape->nNodes(), 2));
    EXPECT_THROW(advance(*group, none, 1e-3), Foam::error);
}


// ************************************************************************* //
