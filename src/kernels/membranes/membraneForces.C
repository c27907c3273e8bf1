// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneForces.H"
#include "laneField.H"
#include "membraneLanes.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Points in a unit of length
static pointField inUnits(const pointField& points, const scalar unit)
{
    return points/unit;
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

void Foam::fsi::membraneForces::addForces
(
    const double* x,
    double* force,
    double* energy
) const
{
    material_.law->addForces(triangles_, x, force, energy);
    if (hinges_.valid())
    {
        hinges_->addForces
        (
            material_.bendingModulus/(modulus()*sqr(unit_)), x, force, energy
        );
    }
}


Foam::scalar Foam::fsi::membraneForces::energy
(
    const Eigen::MatrixXd& positions,
    Eigen::MatrixXd* force
) const
{
    if (force)
    {
        force->resize(positions.rows(), positions.cols());
    }
    const label size = 3*membraneLaw::nLanes*nNodes_;
    laneField x, f;
    x.resize(size);
    f.resize(size);
    scalar sum = 0;
    const labelList all(identity(positions.cols()/3));
    forLaneBlocks(all, [&](const labelUList& copies)
    {
        double energies[membraneLaw::nLanes] = {};
        toLanes(positions, copies, 1/unit_, true, x.data());
        std::fill_n(f.data(), size, 0.0);
        addForces(x.data(), f.data(), energies);
        forAll(copies, lane)
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
            fromLanes(f.data(), copies, modulus()*unit_, false, *force);
        }
    });
    return sum*modulus()*sqr(unit_);
}


Foam::scalar Foam::fsi::membraneForces::largestRatio
(
    const Eigen::MatrixXd& positions,
    const label copyi
) const
{
    scalar most = 1;
    const scalar* x = positions.col(3*copyi).data();
    const auto place = [&](const label nodei)
    {
        const scalar* at = x + nodei;
        return point(at[0], at[nNodes_], at[2*nNodes_])/unit_;
    };
    for (const membraneTriangle& t : triangles_)
    {
        scalar half, ofArea;
        t.squares
        (
            place(t.nodes[0]), place(t.nodes[1]), place(t.nodes[2]),
            half, ofArea
        );
        const scalar larger = half + sqrt(max(sqr(half) - ofArea, scalar(0)));
        most = max(most, larger/sqrt(max(ofArea, scalar(1))));
    }
    return most;
}


// ************************************************************************* //
