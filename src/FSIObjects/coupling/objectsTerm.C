// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsTerm.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- What a cell's pressure does to a component of a node [m^2]
struct cellLoad
{
    label cell;
    label dof;
    scalar value;
};


//- Loads of all cells, by cell and component: those that a cell has on one
//  node stand together, so that they can be summed before they are squared
static std::vector<cellLoad> sortedLoads(const interfaceGeometry& geometry)
{
    std::vector<cellLoad> loads;
    for (const wallFace& w : geometry.wallFaces())
    {
        for (label k = 0; k < 3 && w.place.nodes[k] >= 0; ++k)
        {
            const label dof = 3*w.place.nodes[k] + w.dir;
            const scalar value = w.area*w.place.weights[k];
            if (w.lower >= 0)
            {
                loads.push_back({w.lower, dof, value});
            }
            if (w.upper >= 0)
            {
                loads.push_back({w.upper, dof, -value});
            }
        }
    }
    std::sort
    (
        loads.begin(),
        loads.end(),
        [](const cellLoad& a, const cellLoad& b)
        {
            return a.cell != b.cell ? a.cell < b.cell : a.dof < b.dof;
        }
    );
    return loads;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectsTerm::rowSums(scalarField& d) const
{
    vectorField uniform(system_.walls.uniformForce());
    fsiSystem::groupNodal force;
    system_.toBoundary(uniform, force);

    const scalar dt = system_.deltaT();
    forAll(force, groupi)
    {
        if (system_.objects.groups()[groupi].free())
        {
            Eigen::MatrixXd v;
            system_.objects.groups()[groupi].response().matrix().solveBoundary
            (
                force[groupi],
                v
            );
            force[groupi] = (dt*system_.fluidDensity)*v;
        }
        else
        {
            force[groupi].setZero();
        }
    }
    system_.fromBoundary(force, uniform);
    system_.walls.grossFlux(uniform, d);
}


void Foam::fsi::objectsTerm::nodeDiagonal(scalarField& d) const
{
    const scalar dt = system_.deltaT();
    const surfaceSet& surfaces = system_.objects.surfaces();

    // dt rho/A_ii per surface node and component
    vectorField mobility(surfaces.points().size(), Zero);
    forAll(surfaces.pointObject(), nodei)
    {
        const label objecti = surfaces.pointObject()[nodei];
        const label copyi = system_.objects.objectCopy(objecti);
        const bodyGroup& group =
            system_.objects.groups()[system_.objects.objectGroup(objecti)];
        if (group.free())
        {
            const responseMatrix& A = group.response().matrix();
            const label i = nodei - surfaces.pointStart()[objecti];
            for (direction d = 0; d < group.shape().nDims(); ++d)
            {
                mobility[nodei][d] =
                    dt*system_.fluidDensity/A.diagonal(copyi, i, d);
            }
        }
    }

    const std::vector<cellLoad> loads(sortedLoads(system_.geometry));

    d = Zero;
    for (std::size_t i = 0; i < loads.size();)
    {
        scalar sum = 0;
        const std::size_t first = i;
        for
        (
            ;
            i < loads.size()
         && loads[i].cell == loads[first].cell
         && loads[i].dof == loads[first].dof;
            ++i
        )
        {
            sum += loads[i].value;
        }
        const label dof = loads[first].dof;
        d[loads[first].cell] += sqr(sum)*mobility[dof/3][dof % 3];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectsTerm::objectsTerm(const fsiSystem& system)
:
    system_(system),
    levels_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectsTerm::velocity
(
    const scalarField& p,
    vectorField& v
) const
{
    system_.walls.transpose(p, nodal_);
    nodal_ *= system_.fluidDensity;
    system_.toBoundary(nodal_, force_);

    velocity_.setSize(force_.size());
    forAll(force_, groupi)
    {
        velocity_[groupi].resize(force_[groupi].rows(), force_[groupi].cols());
        system_.objects.groups()[groupi].respondBoundary
        (
            force_[groupi],
            velocity_[groupi]
        );
    }
    system_.fromBoundary(velocity_, v);
}


void Foam::fsi::objectsTerm::add
(
    scalarField& Ax,
    const scalarField& x
) const
{
    // J' is +1 outward of the lower cell, and p pushes the nodes outward of
    // the fluid with the same sign: K is positive semi-definite
    velocity(x, nodal_);
    flux_.setSize(x.size());
    system_.walls.flux(nodal_, flux_);
    Ax += flux_;
}


Foam::tmp<Foam::scalarField> Foam::fsi::objectsTerm::diagonal() const
{
    const label nCells = system_.grid.mesh().nCells();
    auto td = tmp<scalarField>::New(nCells, Zero);
    rowSums(td.ref());

    scalarField d(nCells);
    nodeDiagonal(d);
    td.ref() = max(max(td(), d), 0.0);
    return td;
}


// ************************************************************************* //
