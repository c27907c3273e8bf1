// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneLanes.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Eigen::MatrixXd Foam::fsi::rowsOf(const UList<point>& points)
{
    Eigen::MatrixXd rows(points.size(), 3);
    forAll(points, i)
    {
        rows.row(i) << points[i].x(), points[i].y(), points[i].z();
    }
    return rows;
}


Foam::vectorField Foam::fsi::vectorsOf
(
    const Eigen::Ref<const Eigen::MatrixXd>& rows
)
{
    vectorField vectors(rows.rows(), Zero);
    for (Eigen::Index d = 0; d < rows.cols(); ++d)
    {
        forAll(vectors, i)
        {
            vectors[i][d] = rows(i, d);
        }
    }
    return vectors;
}


void Foam::fsi::toLanes
(
    const Eigen::MatrixXd& values,
    const direction nDims,
    const labelUList& copies,
    const scalar factor,
    const bool relative,
    double* lanes
)
{
    constexpr label nLanes = membraneLaw::nLanes;
    for (label lane = 0; lane < nLanes; ++lane)
    {
        const label copyi = copies[lane < copies.size() ? lane : 0];
        for (label d = nDims; d < 3; ++d)
        {
            for (label nodei = 0; nodei < values.rows(); ++nodei)
            {
                lanes[nLanes*(3*nodei + d) + lane] = 0;
            }
        }
        for (label d = 0; d < nDims; ++d)
        {
            const auto column = values.col(nDims*copyi + d);
            const scalar origin = relative ? column[0] : 0;
            for (label nodei = 0; nodei < column.size(); ++nodei)
            {
                lanes[nLanes*(3*nodei + d) + lane] =
                    factor*(column[nodei] - origin);
            }
        }
    }
}


void Foam::fsi::fromLanes
(
    const double* lanes,
    const direction nDims,
    const labelUList& copies,
    const scalar factor,
    const bool add,
    Eigen::MatrixXd& values
)
{
    constexpr label nLanes = membraneLaw::nLanes;
    forAll(copies, lane)
    {
        for (label d = 0; d < nDims; ++d)
        {
            auto column = values.col(nDims*copies[lane] + d);
            for (label nodei = 0; nodei < column.size(); ++nodei)
            {
                const scalar value =
                    factor*lanes[nLanes*(3*nodei + d) + lane];
                column[nodei] = add ? column[nodei] + value : value;
            }
        }
    }
}


// ************************************************************************* //
