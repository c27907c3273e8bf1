// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneForces.H"
#include "laneField.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static constexpr label nLanes = membraneLaw::nLanes;


//- Points in a unit of length
static pointField inUnits(const pointField& points, const scalar unit)
{
    return points/unit;
}


//- Put copies side by side, from their first node and in the unit of length.
//  Lanes without a copy get the first one
static void toLanes
(
    const Eigen::MatrixXd& positions,
    const label first,
    const scalar perUnit,
    double* x
)
{
    const label nCopies = positions.cols()/3;
    for (label lane = 0; lane < nLanes; ++lane)
    {
        const label copyi = first + lane < nCopies ? first + lane : first;
        for (label d = 0; d < 3; ++d)
        {
            const auto values = positions.col(3*copyi + d);
            for (label nodei = 0; nodei < values.size(); ++nodei)
            {
                x[nLanes*(3*nodei + d) + lane] =
                    perUnit*(values[nodei] - values[0]);
            }
        }
    }
}


//- Take the values of copies from their lanes, in a unit
static void fromLanes
(
    const double* values,
    const label first,
    const scalar unit,
    Eigen::MatrixXd& result
)
{
    const label n = min(nLanes, label(result.cols())/3 - first);
    for (label lane = 0; lane < n; ++lane)
    {
        for (label d = 0; d < 3; ++d)
        {
            auto column = result.col(3*(first + lane) + d);
            for (label nodei = 0; nodei < column.size(); ++nodei)
            {
                column[nodei] = unit*values[nLanes*(3*nodei + d) + lane];
            }
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneForces::membraneForces
(
    const sheetMaterial& material,
    const shapeMesh& mesh,
    const scalar unit
)
:
    material_(material),
    unit_(unit),
    nNodes_(mesh.points.size()),
    triangles_(mesh.faces.size())
{
    const pointField points(inUnits(mesh.points, unit));
    forAll(triangles_, i)
    {
        triangles_[i] = membraneTriangle(mesh.faces[i], points);
    }
    if (material.bendingModulus > 0)
    {
        hinges_.reset(new membraneHinges(points, mesh.faces, material.flat));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::membraneForces::energy
(
    const Eigen::MatrixXd& positions,
    Eigen::MatrixXd* force
) const
{
    const label nCopies = positions.cols()/3;
    const scalar modulus = material_.shearModulus;
    if (force)
    {
        force->resize(positions.rows(), positions.cols());
    }
    laneField x, f;
    x.resize(3*nNodes_*nLanes);
    f.resize(3*nNodes_*nLanes);
    scalar sum = 0;
    for (label first = 0; first < nCopies; first += nLanes)
    {
        double energies[nLanes] = {};
        toLanes(positions, first, 1/unit_, x.data());
        std::fill_n(f.data(), 3*nNodes_*nLanes, 0.0);
        material_.law->addForces(triangles_, x.data(), f.data(), energies);
        if (hinges_.valid())
        {
            hinges_->addForces
            (
                material_.bendingModulus/(modulus*sqr(unit_)),
                x.data(),
                f.data(),
                energies
            );
        }
        for (label lane = 0; lane < min(nLanes, nCopies - first); ++lane)
        {
            // See wormLikeMembrane
            if (force && energies[lane] > 1e50)
            {
                FatalErrorInFunction
                    << "An edge of a membrane has reached the largest length"
                    << " that its law " << material_.law->type() << " allows:"
                    << " take smaller forces, a smaller time step or another"
                    << " law" << exit(FatalError);
            }
            sum += energies[lane];
        }
        if (force)
        {
            fromLanes(f.data(), first, modulus*unit_, *force);
        }
    }
    return sum*modulus*sqr(unit_);
}


Foam::scalar Foam::fsi::membraneForces::largestRatio
(
    const Eigen::MatrixXd& positions
) const
{
    // The unit of length drops out
    scalar most = 1;
    for (label column = 0; column < positions.cols(); column += 3)
    {
        const scalar* x = positions.col(column).data();
        const auto place = [&](const label nodei)
        {
            const scalar* at = x + nodei;
            return point(at[0], at[nNodes_], at[2*nNodes_]);
        };
        for (const membraneTriangle& t : triangles_)
        {
            scalar half, ofArea;
            t.squares
            (
                place(t.nodes[0]), place(t.nodes[1]), place(t.nodes[2]),
                half, ofArea
            );
            most = max(most, sqr(half)/max(ofArea, VSMALL));
        }
    }
    return sqrt(most) + sqrt(most - 1);
}


// ************************************************************************* //
