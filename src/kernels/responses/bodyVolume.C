// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyVolume.H"
#include "vectorField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using Foam::fsi::bodyVolume;

//- Nodes less the first one
class fromFirst
{
    //- Columns of x, y and z; in two dimensions z is x times 0
    const scalar* x_[3];

    const scalar third_;

    const vector first_;

    vector place(const label i) const
    {
        return vector(x_[0][i], x_[1][i], third_*x_[2][i]);
    }

public:

    explicit fromFirst(const bodyVolume::nodes& x)
    :
        x_
        {
            x.data(),
            x.data() + x.outerStride(),
            x.data() + (x.cols() == 3 ? 2*x.outerStride() : 0)
        },
        third_(x.cols() == 3 ? 1 : 0),
        first_(place(0))
    {}

    vector operator[](const label i) const { return place(i) - first_; }
};


//- Add a segment's part of the area's polynomial
void addSegment
(
    const vector (&p)[3],
    const vector (&q)[3],
    FixedList<scalar, 4>& c
)
{
    const vector &pa = p[0], &pb = p[1], &qa = q[0], &qb = q[1];
    c[0] += 0.5*(pa.x()*pb.y() - pa.y()*pb.x());
    c[1] += 0.5
       *(pa.x()*qb.y() - pa.y()*qb.x() + qa.x()*pb.y() - qa.y()*pb.x());
    c[2] += 0.5*(qa.x()*qb.y() - qa.y()*qb.x());
}


//- Add a triangle's part of the volume's polynomial
void addTriangle
(
    const vector (&p)[3],
    const vector (&q)[3],
    FixedList<scalar, 4>& c
)
{
    const vector pp(p[1]^p[2]), qq(q[1]^q[2]);
    const vector pq((p[1]^q[2]) + (q[1]^p[2]));
    c[0] += (p[0] & pp)/6;
    c[1] += ((p[0] & pq) + (q[0] & pp))/6;
    c[2] += ((p[0] & qq) + (q[0] & pq))/6;
    c[3] += (q[0] & qq)/6;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyVolume::bodyVolume
(
    const List<surfaceFace>& faces,
    const nodes& p,
    const nodes& q
)
:
    coefficients_(scalar(0))
{
    const label nDims = p.cols();
    const fromFirst nodes(p), along(q);
    vector points[3], directions[3];
    for (const surfaceFace& face : faces)
    {
        for (label i = 0; i < nDims; ++i)
        {
            points[i] = nodes[face[i]];
            directions[i] = along[face[i]];
        }
        if (nDims == 2)
        {
            addSegment(points, directions, coefficients_);
        }
        else
        {
            addTriangle(points, directions, coefficients_);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::bodyVolume::value(const scalar f) const
{
    const FixedList<scalar, 4>& c = coefficients_;
    return c[0] + f*(c[1] + f*(c[2] + f*c[3]));
}


Foam::scalar Foam::fsi::bodyVolume::derivative(const scalar f) const
{
    const FixedList<scalar, 4>& c = coefficients_;
    return c[1] + f*(2*c[2] + f*3*c[3]);
}


Foam::scalar Foam::fsi::bodyVolume::factorFor(const scalar volume) const
{
    const FixedList<scalar, 4>& c = coefficients_;
    const scalar excess = c[0] - volume;
    scalar f = 0;
    for (label iteration = 0; iteration < 4; ++iteration)
    {
        f -= (excess + f*(c[1] + f*(c[2] + f*c[3])))/derivative(f);
    }
    return f;
}


Foam::scalar Foam::fsi::bodyVolume::of
(
    const List<surfaceFace>& faces,
    const nodes& points
)
{
    const fromFirst x(points);
    const bool plane = points.cols() == 2;
    scalar volume = 0;
    for (const surfaceFace& face : faces)
    {
        const vector a(x[face[0]]), b(x[face[1]]);
        volume +=
            plane
          ? 0.5*(a.x()*b.y() - a.y()*b.x())
          : (a & (b ^ x[face[2]]))/6;
    }
    return volume;
}


void Foam::fsi::bodyVolume::addGradient
(
    const List<surfaceFace>& faces,
    const scalar thickness,
    const nodes& points,
    Eigen::Ref<Eigen::MatrixXd> gradient
)
{
    const label nDims = points.cols();
    const fromFirst x(points);
    for (const surfaceFace& face : faces)
    {
        // Each node has the same share of the area vector
        const vector a(x[face[0]]), d(x[face[1]] - a);
        const vector share
        (
            nDims == 2
          ? (0.5*thickness)*vector(d.y(), -d.x(), 0)
          : (d^(x[face[2]] - a))/6
        );
        for (label i = 0; i < nDims; ++i)
        {
            for (label k = 0; k < nDims; ++k)
            {
                gradient(face[i], k) += share[k];
            }
        }
    }
}


Foam::scalar Foam::fsi::bodyVolume::factorAlongGradient
(
    const List<surfaceFace>& faces,
    const nodes& x,
    const nodes& gradient,
    const scalar volume
)
{
    // V is homogeneous: x.dV/dx is V times the number of dimensions
    const scalar excess =
        (x.rowwise() - x.row(0)).cwiseProduct(gradient).sum()/x.cols() - volume;
    return
        mag(excess) < small*volume
      ? -excess/gradient.squaredNorm()
      : bodyVolume(faces, x, gradient).factorFor(volume);
}


// ************************************************************************* //
