// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneViscosity.H"

#include "membraneLanes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Two sides of a triangle and their metric g_11, g_12, g_22. The second side
//  of a segment is the unit vector along z
struct triangleSides
{
    Eigen::Vector3d e1;
    Eigen::Vector3d e2;
    Eigen::Vector3d metric;

    template<class Positions>
    triangleSides(const Positions& x, const surfaceFace& f)
    :
        e1(inSpace(x.row(f[1]) - x.row(f[0]))),
        e2(Eigen::Vector3d::UnitZ())
    {
        if (f[2] >= 0)
        {
            e2 = inSpace(x.row(f[2]) - x.row(f[0]));
        }
        metric << e1.dot(e1), e1.dot(e2), e2.dot(e2);
    }
};


//- Determinant of a metric
template<class Metric>
static scalar determinant(const Metric& m)
{
    return m[0]*m[2] - m[1]*m[1];
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneViscosity::membraneViscosity
(
    const sheetMaterial& material,
    const shapeMesh& mesh,
    const scalar depth
)
:
    modulus_(material.viscousModulus),
    time_(material.membraneViscosity/material.viscousModulus),
    triangles_(mesh.faces),
    part_(mesh.faces[0][2] < 0 ? depth : 0.5),
    rest_(3*mesh.faces.size()),
    natural_(3*mesh.faces.size(), 0)
{
    const Eigen::MatrixXd x(rowsOf(mesh.points));
    forAll(triangles_, i)
    {
        rest_.segment<3>(3*i) = triangleSides(x, triangles_[i]).metric;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::membraneViscosity::sound() const
{
    bool sound = true;
    for (Eigen::Index i = 0; i + 2 < natural_.size(); i += 3)
    {
        const scalar* h = natural_.data() + i;
        sound = sound && h[0] > 0 && h[2] > 0 && determinant(h) > 0;
    }
    return sound;
}


void Foam::fsi::membraneViscosity::resize(const label nCopies)
{
    natural_.conservativeResize(rest_.size(), nCopies);
}


void Foam::fsi::membraneViscosity::addForce
(
    const Eigen::MatrixXd& positions,
    Eigen::MatrixXd& force
) const
{
    for (label copyi = 0; copyi < natural_.cols(); ++copyi)
    {
        const direction nDims = positions.cols()/natural_.cols();
        const auto x = ofCopy(positions, nDims, copyi);
        auto f = ofCopy(force, nDims, copyi);
        const auto add = [&](const label nodei, const Eigen::Vector3d& push)
        {
            f.row(nodei) += push.transpose().leftCols(nDims);
        };
        forAll(triangles_, i)
        {
            const surfaceFace& t = triangles_[i];
            const triangleSides sides(x, t);
            const Eigen::Vector3d& g = sides.metric;
            const auto h = natural_.col(copyi).segment<3>(3*i);

            // H^ij/sqrt(det g/det H) less half of its trace times g^ij
            const scalar det = determinant(g);
            const scalar area = part_*std::sqrt(det);
            const scalar per = 1/std::sqrt(det*determinant(h));
            const Eigen::Vector3d inverse(h[2]*per, -h[1]*per, h[0]*per);
            const scalar half =
                0.5*inverse[0]*g[0] + inverse[1]*g[1] + 0.5*inverse[2]*g[2];
            const Eigen::Vector3d s
            (
                area*modulus_
               *(inverse - half/det*Eigen::Vector3d(g[2], -g[1], g[0]))
            );
            const Eigen::Vector3d f1(s[0]*sides.e1 + s[1]*sides.e2);
            const Eigen::Vector3d f2(s[1]*sides.e1 + s[2]*sides.e2);
            add(t[0], f1 + f2);
            add(t[1], -f1);
            if (t[2] >= 0)
            {
                add(t[2], -f2);
            }
        }
    }
}


void Foam::fsi::membraneViscosity::relax
(
    const scalar dt,
    const Eigen::MatrixXd& positions
)
{
    const scalar part = dt/(time_ + dt);
    for (label copyi = 0; copyi < natural_.cols(); ++copyi)
    {
        const auto x = ofCopy
        (
            positions, positions.cols()/natural_.cols(), copyi
        );
        forAll(triangles_, i)
        {
            const Eigen::Vector3d g(triangleSides(x, triangles_[i]).metric);
            auto h = natural_.col(copyi).segment<3>(3*i);
            // Only the shear counts: the area of both metrics is the same
            h *= std::sqrt(determinant(g)/determinant(h));
            h += part*(g - h);
        }
    }
}


// ************************************************************************* //
