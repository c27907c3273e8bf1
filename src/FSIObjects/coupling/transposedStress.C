// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"

#include <Eigen/Dense>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef Eigen::Matrix2d tensor2D;

static Eigen::Vector2d inPlane(const vector& v)
{
    return {v.x(), v.y()};
}


//- Surface nodes' vectors t of all objects, see transposedModes
static vectorField rotationModes(const fsiSystem& system)
{
    const surfaceSet& surfaces = system.objects.surfaces();
    const pointField& x = surfaces.points();
    const scalar viscosity =
        system.fluidDensity*system.viscosity*system.grid.thickness();

    vectorField modes(x.size());
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label n = surfaces.pointStart()[objecti + 1] - start;
        const SubList<point> points(x, n, start);
        const vector centre(sum(points)/n);
        scalar second = 0;
        for (const point& p : points)
        {
            second += sqr(p.x() - centre.x()) + sqr(p.y() - centre.y());
        }
        // A rotation omega has the torque -2 rho nu V omega
        const scalar scale =
            Foam::sqrt(2*viscosity*surfaces.volume(objecti))/second;
        for (label i = start; i < start + n; ++i)
        {
            modes[i] =
                scale*vector(centre.y() - x[i].y(), x[i].x() - centre.x(), 0);
        }
    }
    return modes;
}


//- Add the force of the rotation nearest to v
static void addRotationForce
(
    const fsiSystem& system,
    const vectorField& v,
    vectorField& force
)
{
    const vectorField modes(rotationModes(system));
    const labelList& start = system.objects.surfaces().pointStart();
    for (label objecti = 0; objecti + 1 < start.size(); ++objecti)
    {
        scalar amount = 0;
        for (label i = start[objecti]; i < start[objecti + 1]; ++i)
        {
            amount += modes[i] & v[i];
        }
        for (label i = start[objecti]; i < start[objecti + 1]; ++i)
        {
            force[i] -= amount*modes[i];
        }
    }
}


//- Add the force of the linear field nearest to v on one object, whose nodes
//  and faces are those from start to end in the surfaces' lists
static void addLinearForce
(
    const vectorField& x,
    const vectorField& v,
    const SubList<surfaceFace>& faces,
    const labelPair& nodes,
    const scalar viscosity,
    vectorField& force
)
{
    const label n = nodes.second() - nodes.first();
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    for (label i = nodes.first(); i < nodes.second(); ++i)
    {
        centre += inPlane(x[i])/n;
    }

    tensor2D second = tensor2D::Zero();
    tensor2D moment = tensor2D::Zero();
    for (label i = nodes.first(); i < nodes.second(); ++i)
    {
        const Eigen::Vector2d arm(inPlane(x[i]) - centre);
        second += arm*arm.transpose();
        moment += inPlane(v[i])*arm.transpose();
    }
    const tensor2D inverse(second.inverse());
    const tensor2D gradient(moment*inverse);

    // First moment of its forces, as a linear field of nodal forces
    tensor2D turn;
    turn << 0, -1, 1, 0;
    tensor2D forces = tensor2D::Zero();
    for (const surfaceFace& face : faces)
    {
        const Eigen::Vector2d a(inPlane(x[face[0]]) - centre);
        const Eigen::Vector2d b(inPlane(x[face[1]]) - centre);
        forces +=
            viscosity*turn*gradient*(b - a)*(0.5*(a + b)).transpose();
    }
    const tensor2D field(forces*inverse);
    for (label i = nodes.first(); i < nodes.second(); ++i)
    {
        const Eigen::Vector2d f(field*(inPlane(x[i]) - centre));
        force[i].x() += f.x();
        force[i].y() += f.y();
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::transposedModes
(
    const fsiSystem& system,
    fsiSystem::groupNodal& t
)
{
    if (system.transposedStress == fsiSystem::transposedPart::rotation)
    {
        system.toBoundary(rotationModes(system), t);
    }
    else
    {
        const label nNodes = system.objects.surfaces().points().size();
        system.toBoundary(vectorField(nNodes, Zero), t);
    }
}


void Foam::fsi::addTransposedForce
(
    const fsiSystem& system,
    const vectorField& v,
    vectorField& force
)
{
    if (system.transposedStress == fsiSystem::transposedPart::rotation)
    {
        addRotationForce(system, v, force);
        return;
    }
    const surfaceSet& surfaces = system.objects.surfaces();
    const scalar viscosity =
        system.fluidDensity*system.viscosity*system.grid.thickness();

    // Faces stand in the order of their objects
    label face = 0;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const label first = face;
        while
        (
            face < surfaces.faces().size()
         && surfaces.faceObject()[face] == objecti
        )
        {
            ++face;
        }
        addLinearForce
        (
            surfaces.points(),
            v,
            SubList<surfaceFace>(surfaces.faces(), face - first, first),
            labelPair
            (
                surfaces.pointStart()[objecti],
                surfaces.pointStart()[objecti + 1]
            ),
            viscosity,
            force
        );
    }
}


// ************************************************************************* //
