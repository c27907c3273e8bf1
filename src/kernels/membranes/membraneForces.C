// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneForces.H"
#include "laneField.H"
#include "mathematicalConstants.H"
#include "membraneLanes.H"
#include "openfoamVersion.H"

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


//- Places of the nodes of a copy, whose columns follow each other
struct placesInUnits
{
    const scalar* first;
    const label nNodes;
    const direction nDims;
    const scalar unit;

    point operator[](const label nodei) const
    {
        const scalar* x = first + nodei;
        return
            point(x[0], x[nNodes], nDims == 2 ? 0 : x[2*nNodes])/unit;
    }
};

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneForces::membraneForces
(
    const sheetMaterial& material,
    const shapeMesh& mesh,
    const scalar unit,
    const scalar depth
)
:
    material_(material),
    unit_(unit),
    nNodes_(mesh.points.size()),
    depth_(depth),
    triangles_(mesh.faces.size())
{
    const pointField points(inUnits(mesh.points, unit));
    forAll(triangles_, i)
    {
        triangles_[i] = membraneTriangle(mesh.faces[i], points, depth/unit);
    }
    if (material.bendingModulus > 0)
    {
        hinges_.reset
        (
            new membraneHinges(points, mesh.faces, material.flat, depth/unit)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::membraneForces::mobility() const
{
    scalar area = 0;
    for (const membraneTriangle& t : triangles_)
    {
        area += t.area;
    }
    area *= sqr(unit_);
    const scalar pi = constant::mathematical::pi;
    const scalar radius =
        nDims() == 2 ? area/(2*pi*depth_) : sqrt(area/(4*pi));
    return nNodes_*radius/(23*area);
}



void Foam::fsi::membraneForces::addForces
(
    const double* x,
    double* force,
    double* energy
) const
{
    material_.law->addForces(triangles_, x, force, energy);
    for (label lane = 0; lane < membraneLaw::nLanes; ++lane)
    {
        // See wormLikeMembrane
        if (energy[lane] > 1e50)
        {
            FatalErrorInFunction
                << "An edge of a membrane has reached the largest length that"
                << " its law " << material_.law->type() << " allows: take"
                << " smaller forces, a smaller time step or another law"
                << exit(FatalError);
        }
    }
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
    const labelUList& chosen,
    Eigen::MatrixXd* force
) const
{
    const label size = 3*membraneLaw::nLanes*nNodes_;
    laneField x, f;
    x.resize(size);
    f.resize(size);
    scalar sum = 0;
    forLaneBlocks(chosen, [&](const labelUList& copies)
    {
        double energies[membraneLaw::nLanes] = {};
        toLanes(positions, nDims(), copies, 1/unit_, true, x.data());
        std::fill_n(f.data(), size, 0.0);
        addForces(x.data(), f.data(), energies);
        forAll(copies, lane)
        {
            sum += energies[lane];
        }
        if (force)
        {
            fromLanes
            (
                f.data(), nDims(), copies, modulus()*unit_, false, *force
            );
        }
    });
    return sum*modulus()*sqr(unit_);
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
    return energy(positions, identityList(positions.cols()/nDims()), force);
}


Foam::scalar Foam::fsi::membraneForces::largestRatio
(
    const Eigen::MatrixXd& positions,
    const label copyi
) const
{
    scalar most = 1;
    const placesInUnits x
    {
        positions.col(nDims()*copyi).data(), nNodes_, nDims(), unit_
    };
    for (const membraneTriangle& t : triangles_)
    {
        scalar half, ofArea;
        t.squares(x, half, ofArea);
        const scalar larger = half + sqrt(max(sqr(half) - ofArea, scalar(0)));
        most = max(most, larger/sqrt(max(ofArea, scalar(1))));
    }
    return most;
}


// ************************************************************************* //
