// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsConductance.H"
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

void Foam::fsi::objectsConductance::rowSums(scalarField& d) const
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


void Foam::fsi::objectsConductance::nodeDiagonal(scalarField& d) const
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


Foam::tmp<Foam::scalarField> Foam::fsi::objectsConductance::diagonal() const
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
