// SPDX-License-Identifier: GPL-3.0-or-later

#include "normalCones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Cosine of the widest cone, 40 degrees
static const scalar smallestCosine = 0.766;

//- Sine of an angle of a triangle below which round-off turns its normal
static const scalar smallestSine = 1e-6;

//- Unit normal of a triangle, zero if it has no area
static vector unitNormal(const point& a, const point& b, const point& c)
{
    const vector u(b - a), v(c - a);
    const vector n(u ^ v);
    const scalar nn = magSqr(n);
    return
        nn > sqr(smallestSine)*magSqr(u)*magSqr(v)
      ? n/sqrt(nn)
      : vector::zero;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::normalCones::update
(
    const surfaceSet& surfaces,
    const label objecti
)
{
    const pointField& points = surfaces.points();
    firstFace_ = surfaces.faceStart()[objecti];
    const label nFaces = surfaces.faceStart()[objecti + 1] - firstFace_;
    start_ = surfaces.pointStart()[objecti];

    axis_.setSize(surfaces.pointStart()[objecti + 1] - start_);
    tangent_.setSize(axis_.size());
    normal_.setSize(nFaces);
    axis_ = Zero;
    for (label i = 0; i < nFaces; ++i)
    {
        const surfaceFace& f = surfaces.faces()[firstFace_ + i];
        normal_[i] = unitNormal(points[f[0]], points[f[1]], points[f[2]]);
        for (const label nodei : f)
        {
            axis_[nodei - start_] += normal_[i];
        }
    }
    for (vector& axis : axis_)
    {
        axis /= max(mag(axis), VSMALL);
    }

    tangent_ = 1;
    for (label i = 0; i < nFaces; ++i)
    {
        for (const label nodei : surfaces.faces()[firstFace_ + i])
        {
            scalar& cosine = tangent_[nodei - start_];
            cosine = min(cosine, axis_[nodei - start_] & normal_[i]);
        }
    }
    for (scalar& t : tangent_)
    {
        t = t > smallestCosine ? sqrt(max(1 - sqr(t), 0.0))/t : wide;
    }
}


// ************************************************************************* //
