// SPDX-License-Identifier: GPL-3.0-or-later

#include "transposedStress.H"
#include "sumOverRanks.H"

#include <Eigen/Dense>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef Eigen::Matrix2d tensor2D;

//- Wall faces of the surface nodes, each face taken apart by its weights
static scalarField facesOfNodes
(
    const interfaceGeometry& geometry,
    const label nNodes
)
{
    scalarField faces(nNodes, Zero);
    for (const wallLink& link : geometry.wallLinks())
    {
        link.place.spread(faces, 1.0);
    }
    sumOverRanks(faces);
    return faces;
}


//- Vectors q of an object's nodes: the sums of v over q are the gradient of the
//  linear field (or the rotation) nearest to v, each node weighted by its faces
static std::vector<Eigen::Vector2d> gradientVectors
(
    const SubField<point>& x,
    const SubField<scalar>& weights,
    const scalar area,
    const bool linear
)
{
    std::vector<Eigen::Vector2d> q(x.size(), Eigen::Vector2d::Zero());
    const point centre(sum(x*weights)/max(sum(weights), VSMALL));
    tensor2D moment(tensor2D::Zero());
    forAll(x, i)
    {
        q[i] = Eigen::Vector2d(x[i].x() - centre.x(), x[i].y() - centre.y());
        moment += weights[i]*q[i]*q[i].transpose();
    }

    tensor2D inverse(tensor2D::Zero());
    const scalar trace = moment.trace();
    const scalar determinant = moment.determinant();
    if (linear && determinant > 1e-6*sqr(trace))
    {
        // Half of what the links resist at most
        inverse =
            Foam::sqrt(min(1.0, determinant/(area*trace)))*moment.inverse();
    }
    else if (!linear && trace > 0)
    {
        inverse = (2/trace)*tensor2D::Identity();
    }
    forAll(x, i)
    {
        q[i] = (weights[i]*inverse*q[i]).eval();
    }
    return q;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Foam::fsi::transposedMode> Foam::fsi::transposedModes
(
    const surfaceSet& surfaces,
    const interfaceGeometry& geometry,
    const scalar viscosity,
    const bool linear
)
{
    const pointField& x = surfaces.points();
    const scalarField weights(facesOfNodes(geometry, x.size()));
    const vectorField none(x.size(), Zero);
    std::vector<transposedMode> modes(1, transposedMode{1, none});
    modes.resize(linear ? 3 : 1, transposedMode{-1, none});
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label n = surfaces.pointStart()[objecti + 1] - start;
        const scalar area = surfaces.volume(objecti);
        const std::vector<Eigen::Vector2d> gradient
        (
            gradientVectors
            (
                SubField<point>(x, n, start),
                SubField<scalar>(weights, n, start),
                area,
                linear
            )
        );
        const scalar strength = Foam::sqrt(0.5*viscosity*area);
        for (label i = 0; i < n; ++i)
        {
            const Eigen::Vector2d q(strength*gradient[i]);
            modes[0].vectors[start + i] = vector(-q.y(), q.x(), 0);
            if (linear)
            {
                modes[1].vectors[start + i] = vector(q.x(), -q.y(), 0);
                modes[2].vectors[start + i] = vector(q.y(), q.x(), 0);
            }
        }
    }
    return modes;
}


std::vector<Foam::fsi::transposedMode> Foam::fsi::transposedModes
(
    const fsiSystem& system
)
{
    return transposedModes
    (
        system.objects.surfaces(),
        system.geometry,
        system.fluidDensity*system.viscosity*system.grid.thickness(),
        system.transposedStrain
    );
}


void Foam::fsi::addTransposedForce
(
    const std::vector<transposedMode>& modes,
    const labelList& pointStart,
    const vectorField& v,
    vectorField& force
)
{
    for (const transposedMode& mode : modes)
    {
        for (label objecti = 0; objecti + 1 < pointStart.size(); ++objecti)
        {
            const label end = pointStart[objecti + 1];
            scalar amount = 0;
            for (label i = pointStart[objecti]; i < end; ++i)
            {
                amount += mode.sign*(mode.vectors[i] & v[i]);
            }
            for (label i = pointStart[objecti]; i < end; ++i)
            {
                force[i] -= amount*mode.vectors[i];
            }
        }
    }
}


// ************************************************************************* //
