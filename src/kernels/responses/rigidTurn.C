// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidTurn.H"
#include "scalar.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Change of the rotation vector w by a further small turn
Eigen::Vector3d changeBy(const Eigen::Vector3d& w, const Eigen::Vector3d& turn)
{
    const double angle = w.norm();
    const double half = 0.5*angle;
    const double c =
        angle < 1e-2
      ? (1 + angle*angle/60)/12
      : (1 - half*std::cos(half)/std::sin(half))/(angle*angle);
    const Eigen::Vector3d across(w.cross(turn));
    return turn - 0.5*across + c*w.cross(across);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Eigen::Matrix3d Foam::fsi::crossMatrix(const Eigen::Vector3d& a)
{
    Eigen::Matrix3d m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}


Eigen::Vector3d Foam::fsi::axialVector(const Eigen::Matrix3d& S)
{
    return Eigen::Vector3d
    (
        S(1, 2) - S(2, 1), S(2, 0) - S(0, 2), S(0, 1) - S(1, 0)
    );
}


Eigen::Vector3d Foam::fsi::angularVelocityOf
(
    const Eigen::Matrix3d& S,
    const Eigen::Vector3d& momentum
)
{
    return
        (S.trace()*Eigen::Matrix3d::Identity() - S).llt().solve(momentum);
}


Eigen::Matrix3d Foam::fsi::exponentialLess1(const Eigen::Vector3d& w)
{
    const double angle = w.norm();
    const double half = 0.5*angle;
    const bool small = angle < 1e-4;
    const double sine = small ? 1 - angle*angle/6 : std::sin(angle)/angle;
    const double ratio = small ? 1 - half*half/6 : std::sin(half)/half;
    const Eigen::Matrix3d K(crossMatrix(w));
    return sine*K + 0.5*ratio*ratio*K*K;
}


bool Foam::fsi::rigidTurn
(
    const Eigen::Matrix3d& S,
    const Eigen::Vector3d& stepMomentum,
    Eigen::Matrix3d& less1
)
{
    const double size = S.trace();
    Eigen::Vector3d w(Eigen::Vector3d::Zero());
    less1.setZero();
    double last = GREAT;
    for (int iteration = 0; iteration < 30; ++iteration)
    {
        // sum m r y^T with y = Q r - r
        const Eigen::Matrix3d T(S*less1.transpose());
        const Eigen::Vector3d missing(stepMomentum - axialVector(T));
        const double error = missing.norm();
        if (!(error < last) || w.norm() > 1)
        {
            break;
        }
        last = error;

        // Newton: a further turn by d changes r x Q r by r x (d x Q r)
        const Eigen::Matrix3d all(S + T);
        const Eigen::Matrix3d J
        (
            all.trace()*Eigen::Matrix3d::Identity() - all.transpose()
        );
        w += changeBy(w, J.partialPivLu().solve(missing));
        less1 = exponentialLess1(w);
    }
    return last <= 1e-12*(stepMomentum.norm() + 1e-3*size);
}


// ************************************************************************* //
