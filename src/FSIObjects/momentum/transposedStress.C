// SPDX-License-Identifier: GPL-3.0-or-later

#include "transposedStress.H"
#include "tensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Wall faces of the surface nodes, each face taken apart by its weights
static scalarField facesOfNodes
(
    const interfaceGeometry& geometry,
    const objectRanks& ranks,
    const label nNodes
)
{
    scalarField faces(nNodes, Zero);
    for (const wallLink& link : geometry.wallLinks())
    {
        link.place.spread(faces, 1.0);
    }
    ranks.collect({objectRanks::values::ofWalls(faces)});
    return faces;
}


//- The tensor whose product with a vector is the cross product
static tensor crossProduct(const vector& w)
{
    return tensor(0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0);
}


//- Axes of the rotations
static List<vector> rotationAxes(const direction nDims)
{
    List<vector> axes({vector(0, 0, 1)});
    if (nDims == 3)
    {
        axes.append(List<vector>({vector(1, 0, 0), vector(0, 1, 0)}));
    }
    return axes;
}


//- Velocity gradients of size 1, normal to each other: the rotations, and the
//  strains free of divergence
static List<tensor> gradients(const direction nDims)
{
    const scalar half = Foam::sqrt(0.5);
    List<tensor> all;
    for (const vector& axis : rotationAxes(nDims))
    {
        all.append(half*crossProduct(axis));
    }
    all.append(half*tensor(1, 0, 0, 0, -1, 0, 0, 0, 0));
    all.append(half*tensor(0, 1, 0, 1, 0, 0, 0, 0, 0));
    if (nDims == 3)
    {
        all.append(half*tensor(0, 0, 1, 0, 0, 0, 1, 0, 0));
        all.append(half*tensor(0, 0, 0, 0, 0, 1, 0, 1, 0));
        all.append(Foam::sqrt(1.0/6)*tensor(1, 0, 0, 0, 1, 0, 0, 0, -2));
    }
    return all;
}


namespace
{

//- Nodes of an object and the wall faces that reach them
class weightedNodes
{
    const SubField<scalar> weights_;
    const direction nDims_;
    vectorField arms_;
    tensor moment_ = Zero;

public:

    weightedNodes
    (
        const SubField<point>& x,
        const SubField<scalar>& weights,
        const direction nDims
    )
    :
        weights_(weights),
        nDims_(nDims),
        arms_(x - sum(x*weights)/max(sum(weights), VSMALL))
    {
        forAll(arms_, i)
        {
            if (nDims_ == 2)
            {
                arms_[i].z() = 0;
            }
            moment_ += weights_[i]*(arms_[i]*arms_[i]);
        }
    }

    //- Factor on the arms in the linear field nearest to the nodes' velocity.
    //  limit: largest sum of its squares over the weights
    tensor linearField(const scalar limit) const
    {
        tensor moment(moment_);
        moment.zz() += nDims_ == 2 ? 1 : 0;
        const scalar trace = tr(moment_);
        if (det(moment) <= 1e-6*Foam::pow(trace, label(nDims_)))
        {
            return Zero;
        }
        tensor inverse(inv(moment));
        inverse.zz() -= nDims_ == 2 ? 1 : 0;
        return Foam::sqrt(min(1.0, limit/tr(inverse)))*inverse;
    }

    //- v_i = w_i T r_i
    void setMode(const tensor& T, const label start, vectorField& v) const
    {
        forAll(arms_, i)
        {
            v[start + i] = weights_[i]*(T & arms_[i]);
        }
    }
};


void addModeForce
(
    const transposedMode& mode,
    const labelList& pointStart,
    const vectorField& v,
    vectorField& force
)
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

} // End anonymous namespace

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Foam::fsi::transposedMode> Foam::fsi::transposedModes
(
    const surfaceSet& surfaces,
    const interfaceGeometry& geometry,
    const scalar viscosity,
    const objectRanks& ranks,
    const scalarField& relative
)
{
    const direction nDims = surfaces.nDims();
    const pointField& x = surfaces.points();
    const scalarField weights(facesOfNodes(geometry, ranks, x.size()));
    const List<tensor> fields(gradients(nDims));
    std::vector<transposedMode> modes;
    modes.reserve(fields.size());
    forAll(fields, k)
    {
        const scalar sign = k < nRotations(nDims) ? 1 : -1;
        modes.push_back({sign, vectorField(x.size(), Zero)});
    }

    // Half of what the links resist at most: they have h each, 1 in a plane
    const scalar conductance = nDims == 2 ? 1 : geometry.grid().spacing();
    const label nOwned = ranks.nOwned(surfaces.size());
    for (label objecti = 0; objecti < nOwned; ++objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label n = surfaces.pointStart()[objecti + 1] - start;
        const scalar volume = surfaces.volume(objecti);
        const weightedNodes nodes
        (
            SubField<point>(x, n, start),
            SubField<scalar>(weights, n, start),
            nDims
        );
        const scalar strength = Foam::sqrt
        (
            viscosity*volume*(relative.empty() ? 1 : relative[objecti])
        );
        const tensor factor
        (
            nodes.linearField(0.5*nDims/(nDims - 1)*conductance/volume)
        );
        forAll(fields, k)
        {
            nodes.setMode
            (
                strength*(fields[k] & factor), start, modes[k].vectors
            );
        }
    }
    return modes;
}


Foam::label Foam::fsi::nRotations(const direction nDims)
{
    return nDims == 2 ? 1 : 3;
}


void Foam::fsi::setTransposedStress
(
    const population& bodies,
    const interfaceGeometry& geometry,
    const fluidProperties& fluid,
    const scalarField& relative,
    std::vector<transposedMode>& rotations,
    vectorField& strainForce
)
{
    rotations.clear();
    const surfaceSet& surfaces = bodies.surfaces();
    strainForce.setSize(surfaces.points().size());
    strainForce = Zero;
    if (bodies.onlyMembranes())
    {
        return;
    }
    // One vector for both kinds: a mode is as large as a field of all nodes
    rotations = transposedModes
    (
        surfaces, geometry,
        fluid.dynamicViscosity()*geometry.grid().thickness(),
        bodies.ranks(),
        relative
    );
    const auto strains = rotations.begin() + nRotations(bodies.nDims());
    for (auto mode = strains; mode != rotations.end(); ++mode)
    {
        addModeForce
        (
            *mode, surfaces.pointStart(), surfaces.velocities(), strainForce
        );
    }
    rotations.erase(strains, rotations.end());
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
        addModeForce(mode, pointStart, v, force);
    }
}


// ************************************************************************* //
