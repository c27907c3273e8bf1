// SPDX-License-Identifier: GPL-3.0-or-later

#include "groupContact.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Boundary nodes of the reference shape
static pointField boundaryPoints(const shapeTemplate& shape)
{
    return pointField
    (
        SubList<point>(shape.points(), shape.nBoundaryNodes())
    );
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::groupContact::groupContact(const bodyGroup& group)
:
    group_(group),
    rest_(boundaryPoints(group.shape())),
    areas_
    (
        contactBodies::nodeAreas
        (
            rest_,
            group.shape().faces(),
            group.shape().nDims(),
            group.shape().thickness()
        )
    )
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::groupContact::addMode
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    const Eigen::MatrixXd& mode,
    const Eigen::VectorXd& coefficients,
    contactBodies& bodies
) const
{
    forAll(objects, copyi)
    {
        const label k = bodies.addMode(objects[copyi], coefficients[copyi]);
        const label start = surfaces.pointStart()[objects[copyi]];
        for (label i = 0; i < areas_.size(); ++i)
        {
            bodies.mode(start + i, k) =
                vector(mode(i, 2*copyi), mode(i, 2*copyi + 1), 0);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::groupContact::setNodes
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    contactBodies& bodies
) const
{
    for (const label objecti : objects)
    {
        bodies.setRest(objecti, rest_);
        if (!group_.free())
        {
            bodies.setPrescribed(objecti);
        }
        const label start = surfaces.pointStart()[objecti];
        forAll(areas_, i)
        {
            bodies.areas()[start + i] = areas_[i];
            bodies.masses()[start + i] = group_.shape().nodeMasses()[i];
        }
    }
}


void Foam::fsi::groupContact::setInternalForces
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    contactBodies& bodies
)
{
    group_.internalForce(internalForce_);
    forAll(objects, copyi)
    {
        const label start = surfaces.pointStart()[objects[copyi]];
        forAll(areas_, i)
        {
            bodies.internalForces()[start + i] = vector
            (
                internalForce_(i, 2*copyi), internalForce_(i, 2*copyi + 1), 0
            );
        }
    }
}


void Foam::fsi::groupContact::setResponse
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    const bool internalForces,
    contactBodies& bodies
)
{
    if (internalForces)
    {
        setInternalForces(surfaces, objects, bodies);
    }
    if (!group_.free() || objects.empty())
    {
        return;
    }

    const bodyResponse& response = group_.response();
    forAll(objects, copyi)
    {
        bodies.setInverse
        (
            objects[copyi],
            &response.matrix().boundaryInverse(copyi),
            response.matrix().coupled()
        );
    }

    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(objects.size());
    addMode(surfaces, objects, response.rotationModes(), ones, bodies);
    addMode(surfaces, objects, response.elasticRotation(), -ones, bodies);
    addMode
    (
        surfaces,
        objects,
        response.volumeMode(),
        -response.volumeCompliance().cwiseInverse(),
        bodies
    );
}


// ************************************************************************* //
