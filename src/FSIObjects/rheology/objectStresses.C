// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectStresses.H"
#include "fsiObjects.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- oint (u n + n u) dA of an object [m3/s], u linear in each face
static symmTensor surfaceStrain
(
    const surfaceSet& surfaces,
    const label objecti,
    const scalar thickness
)
{
    const bool plane = surfaces.nDims() == 2;
    symmTensor sum(Zero);
    for
    (
        label facei = surfaces.faceStart()[objecti];
        facei < surfaces.faceStart()[objecti + 1];
        ++facei
    )
    {
        const surfaceFace& f = surfaces.faces()[facei];
        const pointField& x = surfaces.points();
        const vector d(x[f[1]] - x[f[0]]);
        vector velocity(surfaces.velocities()[f[0]]);
        velocity += surfaces.velocities()[f[1]];
        vector area(thickness*d.y(), -thickness*d.x(), 0);
        if (!plane)
        {
            velocity += surfaces.velocities()[f[2]];
            area = 0.5*(d ^ (x[f[2]] - x[f[0]]));
        }
        sum += twoSymm(area*velocity/scalar(surfaces.nDims()));
    }
    return sum;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectStresses
(
    fsiObjects& objects,
    const vectorField& hydrodynamicForce,
    symmTensorField& stresslets,
    symmTensorField& contactStresses
)
{
    const population& bodies = objects.bodies();
    const surfaceSet& surfaces = bodies.surfaces();
    vectorField& pushes = objects.contact().forces();
    pushes.setSize(surfaces.points().size(), Zero);
    const scalar mu = objects.fluid().dynamicViscosity();
    List<Eigen::MatrixXd> own(bodies.groups().size());
    forAll(own, groupi)
    {
        if (!bodies.groups()[groupi].hasWalls())
        {
            bodies.groups()[groupi].internalForce(own[groupi]);
        }
    }

    stresslets.setSize(bodies.size());
    stresslets = symmTensor(Zero);
    contactStresses.setSize(bodies.size());
    contactStresses = symmTensor(Zero);
    for (label objecti = 0; objecti < bodies.size(); ++objecti)
    {
        const label groupi = bodies.objectGroup(objecti);
        const shapeTemplate& shape = bodies.shape(groupi);
        const point centre(surfaces.centroid(objecti));
        const label start = surfaces.pointStart()[objecti];
        const label end = surfaces.pointStart()[objecti + 1];
        for (label nodei = start; nodei < end; ++nodei)
        {
            const vector arm(surfaces.points()[nodei] - centre);
            vector force(hydrodynamicForce[nodei]);
            for (label d = 0; own[groupi].size() && d < shape.nDims(); ++d)
            {
                force[d] = -own[groupi]
                (
                    nodei - start,
                    shape.nDims()*bodies.objectCopy(objecti) + d
                );
            }
            stresslets[objecti] += symm(arm*force);
            contactStresses[objecti] += symm(arm*pushes[nodei]);
        }
        const scalar inside = shape.sheet() ? shape.sheet()->innerViscosity : 0;
        const scalar viscosity =
            !shape.sheet() ? -mu : inside > 0 ? inside - mu : 0;
        stresslets[objecti] +=
            viscosity*surfaceStrain(surfaces, objecti, shape.thickness());
    }
}


// ************************************************************************* //
