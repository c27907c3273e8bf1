// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyResponse.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Enclosed area of a polygon whose points are p + factor*q
struct quadraticArea
{
    //- area = constant + linear*factor + quadratic*factor^2 [m^2]
    scalar constant = 0, linear = 0, quadratic = 0;

    template<class Points, class Directions>
    quadraticArea
    (
        const List<surfaceFace>& faces,
        const Points& p,
        const Directions& q
    )
    {
        // Relative to the first point, against round-off
        for (const surfaceFace& face : faces)
        {
            const label a = face[0], b = face[1];
            const scalar pax = p(a, 0) - p(0, 0), pay = p(a, 1) - p(0, 1);
            const scalar pbx = p(b, 0) - p(0, 0), pby = p(b, 1) - p(0, 1);
            const scalar qax = q(a, 0) - q(0, 0), qay = q(a, 1) - q(0, 1);
            const scalar qbx = q(b, 0) - q(0, 0), qby = q(b, 1) - q(0, 1);
            constant += 0.5*(pax*pby - pay*pbx);
            linear += 0.5*(pax*qby - pay*qbx + qax*pby - qay*pbx);
            quadratic += 0.5*(qax*qby - qay*qbx);
        }
    }
};

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyResponse::constrainVolume
(
    const scalar dt,
    Eigen::MatrixXd& v
) const
{
    const label nB = shape_.nBoundaryNodes();
    Eigen::MatrixXd end(nB, 2);

    for (label copyi = 0; copyi < positions_.cols()/2; ++copyi)
    {
        auto mode = volumeMode_.middleCols(2*copyi, 2);
        end =
            positions_.middleCols(2*copyi, 2).topRows(nB)
          + dt*v.middleCols(2*copyi, 2).topRows(nB);
        const quadraticArea area(shape_.faces(), end, mode);

        // Newton from the velocity as it is
        const scalar excess = area.constant - shape_.referenceVolume();
        scalar factor = 0;
        for (label iteration = 0; iteration < 4; ++iteration)
        {
            factor -=
                (excess + factor*(area.linear + factor*area.quadratic))
               /(area.linear + 2*factor*area.quadratic);
        }
        v.middleCols(2*copyi, 2) += (factor/dt)*mode;
    }
}


Foam::scalar Foam::fsi::bodyResponse::area
(
    const shapeTemplate& shape,
    const Eigen::MatrixXd& positions,
    const label copyi
)
{
    const auto points = positions.middleCols(2*copyi, 2);
    return quadraticArea(shape.faces(), points, points).constant;
}


// ************************************************************************* //
