// SPDX-License-Identifier: GPL-3.0-or-later

#include "implicitMembraneForces.H"
#include "laneVector.H"
#include "membraneLanes.H"
#include "triangleForces.H"
#include "vectorClones.H"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static constexpr label nLanes = membraneLaw::nLanes;

//- Largest residual over the right-hand side
static constexpr scalar tolerance = 2e-2;

static constexpr label mostIterations = 30;


//- One value for all lanes
static std::array<double, nLanes> all(const scalar value)
{
    std::array<double, nLanes> values;
    values.fill(value);
    return values;
}


//- Inner product of each lane
FSI_AVX2_CLONES
static void products
(
    const label size,
    const double* a,
    const double* b,
    double* sum
)
{
    double sums[nLanes] = {};
    for (label i = 0; i < size; i += nLanes)
    {
        for (label lane = 0; lane < nLanes; ++lane)
        {
            sums[lane] += a[i + lane]*b[i + lane];
        }
    }
    std::copy_n(sums, nLanes, sum);
}


//- Set `result` to a + factor b, with a factor for each lane
FSI_AVX2_CLONES
static void addScaled
(
    const label size,
    const double* a,
    const double* factor,
    const double* b,
    double* result
)
{
    for (label i = 0; i < size; i += nLanes)
    {
        for (label lane = 0; lane < nLanes; ++lane)
        {
            result[i + lane] = a[i + lane] + factor[lane]*b[i + lane];
        }
    }
}


//- The larger one of values and 0
template<class Array>
[[gnu::always_inline]]
static inline Array positive(const Array& a)
{
    return Array(0.5)*(a + (a*a).sqrt());
}


//- Add the product of the stiffness of all triangles, see the header, with a
//  direction
FSI_AVX2_CLONES
static void addStiffness
(
    const scalar C,
    const UList<membraneTriangle>& triangles,
    const double* x,
    const double* direction,
    double* product
)
{
    typedef laneArray<nLanes> Array;
    typedef laneVector<Array> vectors;
    for (const membraneTriangle& t : triangles)
    {
        const vectors origin(vectors::load(x, t.nodes[0]));
        const vectors e1(vectors::load(x, t.nodes[1]) - origin);
        const vectors e2(secondSide(t, x, origin));
        const vectors start(vectors::load(direction, t.nodes[0]));
        const vectors d1(vectors::load(direction, t.nodes[1]) - start);
        const vectors d2
        (
            t.segment() ? start - start : secondSide(t, direction, start)
        );

        const Array g11(e1 & e1), g12(e1 & e2), g22(e2 & e2);
        const Array c11(t.inverse[0]), c12(t.inverse[1]), c22(t.inverse[2]);
        const Array per(t.perDeterminant);
        const Array I1(c11*g11 + c12*(g12 + g12) + c22*g22 - Array(2));
        const Array I2(per*(g11*g22 - g12*g12) - Array(1));

        // Halves of the gradients of I1 and I2
        const vectors a1(c11*e1 + c12*e2), a2(c12*e1 + c22*e2);
        const Array p11(per*g22), p12(per*g12), p22(per*g11);
        const vectors b1(p11*e1 - p12*e2), b2(p22*e2 - p12*e1);
        const Array area(t.area);
        const Array alongA(Array(2)*area*((a1 & d1) + (a2 & d2)));
        const Array alongB(Array(2*C)*area*((b1 & d1) + (b2 & d2)));
        const Array W1(area*positive(I1 + Array(1)));
        const Array W2(area*positive(Array(C)*I2 - Array(1)));
        const Array k11(W1*c11 + W2*p11);
        const Array k12(W1*c12 - W2*p12);
        const Array k22(W1*c22 + W2*p22);
        const vectors f1(alongA*a1 + alongB*b1 + k11*d1 + k12*d2);
        const vectors f2(alongA*a2 + alongB*b2 + k12*d1 + k22*d2);
        addAtEnds(t, f1, f2, product);
    }
}


//- Change the forces on the nodes of a copy as little as possible so that they
//  have no torque
template<class Positions, class Forces>
static void removeTorque(const Positions& x, Forces&& force)
{
    const Eigen::RowVectorXd centre(x.colwise().mean());
    const auto arm = [&](const Eigen::Index i)
    {
        return inSpace(x.row(i) - centre);
    };
    Eigen::Matrix3d inertia(Eigen::Matrix3d::Zero());
    Eigen::Vector3d torque(Eigen::Vector3d::Zero());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
    {
        const Eigen::Vector3d r(arm(i));
        inertia +=
            r.squaredNorm()*Eigen::Matrix3d::Identity() - r*r.transpose();
        torque += r.cross(inSpace(force.row(i)));
    }
    const Eigen::Vector3d turn(inertia.ldlt().solve(torque));
    for (Eigen::Index i = 0; i < x.rows(); ++i)
    {
        force.row(i) -=
            turn.cross(arm(i)).transpose().leftCols(force.cols());
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::implicitMembraneForces::solve(const scalar softness)
{
    const double* r = residual_.data();
    const double* p = direction_.data();
    std::fill_n(change_.data(), size_, 0.0);
    std::copy_n(r, size_, direction_.data());
    double square[nLanes], enough[nLanes];
    products(size_, r, r, square);
    for (label lane = 0; lane < nLanes; ++lane)
    {
        enough[lane] = sqr(tolerance)*square[lane];
    }
    for (label iteration = 0; iteration < mostIterations; ++iteration)
    {
        // Lanes that are done stay as they are
        bool active[nLanes];
        bool any = false;
        for (label lane = 0; lane < nLanes; ++lane)
        {
            active[lane] = square[lane] > enough[lane];
            any = any || active[lane];
        }
        if (!any)
        {
            return;
        }
        std::fill_n(image_.data(), size_, 0.0);
        addStiffness
        (
            forces_.law().ofSkalak(), forces_.triangles(),
            x_.data(), p, image_.data()
        );
        addScaled(size_, p, all(softness).data(), image_.data(), image_.data());

        double curvature[nLanes], along[nLanes], back[nLanes];
        products(size_, p, image_.data(), curvature);
        for (label lane = 0; lane < nLanes; ++lane)
        {
            along[lane] = active[lane] ? square[lane]/curvature[lane] : 0;
            back[lane] = -along[lane];
        }
        addScaled(size_, change_.data(), along, p, change_.data());
        addScaled(size_, r, back, image_.data(), residual_.data());
        double next[nLanes], factor[nLanes];
        products(size_, r, r, next);
        for (label lane = 0; lane < nLanes; ++lane)
        {
            factor[lane] = next[lane]/max(square[lane], VSMALL);
            square[lane] = next[lane];
        }
        addScaled(size_, r, factor, p, direction_.data());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::implicitMembraneForces::implicitMembraneForces
(
    const membraneForces& forces
)
:
    forces_(forces),
    size_(3*nLanes*forces.nNodes())
{
    for
    (
        laneField* field
      : {
            &x_, &f_, &residual_, &direction_, &image_, &change_
        }
    )
    {
        field->resize(size_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::implicitMembraneForces::correct
(
    const labelUList& copies,
    const scalar softness,
    const Eigen::MatrixXd& positions,
    const Eigen::MatrixXd& predicted,
    Eigen::MatrixXd& force
)
{
    const scalar ofForce = forces_.modulus()*forces_.unit();
    const direction nDims = forces_.nDims();
    forLaneBlocks(copies, [&](const labelUList& block)
    {
        double energies[nLanes] = {};
        toLanes
        (
            predicted, nDims, block, 1/forces_.unit(), true, x_.data()
        );
        toLanes(force, nDims, block, 1/ofForce, false, change_.data());
        std::fill_n(f_.data(), size_, 0.0);
        forces_.addForces(x_.data(), f_.data(), energies);
        addScaled
        (
            size_, f_.data(), all(-1).data(), change_.data(), residual_.data()
        );
        solve(softness*forces_.modulus());
        fromLanes(change_.data(), nDims, block, ofForce, true, force);
    });
    for (const label copyi : copies)
    {
        removeTorque
        (
            ofCopy(positions, nDims, copyi), ofCopy(force, nDims, copyi)
        );
    }
}


// ************************************************************************* //
