// SPDX-License-Identifier: GPL-3.0-or-later

#include "groupContact.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Boundary nodes near to clamped ones, in the rest shape
static labelList nodesNearClamps
(
    const shapeTemplate& shape,
    const scalar distance
)
{
    const labelList clamped(shape.held().clamped());
    DynamicList<label> near;
    for (label nodei = 0; nodei < shape.nBoundaryNodes(); ++nodei)
    {
        for (const label other : clamped)
        {
            if (mag(shape.points()[nodei] - shape.points()[other]) <= distance)
            {
                near.append(nodei);
                break;
            }
        }
    }
    return labelList(near);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::groupContact::groupContact
(
    const bodyGroup& group,
    const scalar range
)
:
    group_(group),
    rest_(group.shape().boundaryPoints()),
    areas_
    (
        contactBodies::nodeAreas
        (
            rest_,
            group.shape().faces(),
            group.shape().nDims(),
            group.shape().thickness()
        )
    ),
    sheltered_(nodesNearClamps(group.shape(), 2*range))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::groupContact::valueAt
(
    const Eigen::MatrixXd& values,
    const label nodei,
    const label copyi
) const
{
    const label nDims = group_.shape().nDims();
    vector value(Zero);
    for (label d = 0; d < nDims; ++d)
    {
        value[d] = values(nodei, nDims*copyi + d);
    }
    return value;
}


void Foam::fsi::groupContact::addMode
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    const bodyResponse::mode& mode,
    contactBodies& bodies
) const
{
    forAll(objects, copyi)
    {
        const label k = bodies.addMode(objects[copyi], mode.sign);
        const label start = surfaces.pointStart()[objects[copyi]];
        for (label i = 0; i < areas_.size(); ++i)
        {
            bodies.mode(start + i, k) = valueAt(mode.values, i, copyi);
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
        if (group_.keepsShape())
        {
            bodies.setKeepsShape(objecti);
        }
        if (!group_.movesFreely())
        {
            bodies.setPrescribed(objecti);
        }
        const label start = surfaces.pointStart()[objecti];
        forAll(areas_, i)
        {
            bodies.areas()[start + i] = areas_[i];
            bodies.masses()[start + i] = group_.shape().nodeMasses()[i];
        }
        for (const label i : sheltered_)
        {
            bodies.setSheltered(start + i);
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
            bodies.internalForces()[start + i] =
                valueAt(internalForce_, i, copyi);
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
    const bodyResponse& response = group_.response();
    if (response.hasMatrix())
    {
        for (const label objecti : objects)
        {
            bodies.setInverse(objecti, &response.matrix().boundaryInverse());
        }
    }
    for (const bodyResponse::mode& mode : response.modes())
    {
        addMode(surfaces, objects, mode, bodies);
    }
}


// ************************************************************************* //
