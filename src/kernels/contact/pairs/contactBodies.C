// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactBodies.H"
#include "periodicImages.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactBodies::reset(const surfaceSet& surfaces)
{
    // Membranes inside the fluid do not touch
    const label nNodes =
        periodicImages::anyWalls(surfaces) ? surfaces.points().size() : 0;

    bodies_.setSize(surfaces.size());
    bodies_ = body();
    forAll(bodies_, objecti)
    {
        bodies_[objecti].id = objecti;
    }
    sheltered_.setSize(nNodes);
    sheltered_ = false;
    modes_.setSize(maxModes*nNodes);
    areas_.setSize(nNodes);
    areas_ = 0;
    masses_.setSize(nNodes);
    masses_ = 0;
    internalForces_.setSize(nNodes);
    internalForces_ = Zero;
}


void Foam::fsi::contactBodies::setInverse
(
    const label objecti,
    const Eigen::MatrixXd* inverse
)
{
    bodies_[objecti].inverse = inverse;
}


Foam::label Foam::fsi::contactBodies::addMode
(
    const label objecti,
    const scalar coefficient
)
{
    body& b = bodies_[objecti];
    if (b.nModes == maxModes)
    {
        FatalErrorInFunction
            << "Object " << objecti << " has " << maxModes
            << " modes already" << exit(FatalError);
    }
    b.coefficients[b.nModes] = coefficient;
    return b.nModes++;
}


Foam::scalar Foam::fsi::contactBodies::coupling
(
    const surfaceSet& surfaces,
    const label objecti,
    const contactPair& pair,
    const contactPair& by
) const
{
    // Nodes of the object in a pair with their parts in its velocity
    const auto forNodes = [&](const contactPair& p, const auto& action)
    {
        const label own = surfaces.pointObject()[p.node];
        if (own == objecti)
        {
            action(p.node, p.normal);
        }
        const bool face = p.face >= 0 && p.faceOwner(own) == objecti;
        for (label i = 0; face && i < surfaces.nNodes(); ++i)
        {
            action(surfaces.faces()[p.face][i], vector(-p.share(i)));
        }
    };
    const body& b = bodies_[objecti];
    const label start = surfaces.pointStart()[objecti];
    scalar sum = 0;
    forNodes(pair, [&](const label i, const vector& part)
    {
        forNodes(by, [&](const label j, const vector& byPart)
        {
            if (b.inverse)
            {
                sum +=
                    (part & byPart)
                   *(*b.inverse)(i - start, j - start);
            }
            for (label k = 0; k < b.nModes; ++k)
            {
                sum +=
                    b.coefficients[k]
                   *(mode(i, k) & part)*(mode(j, k) & byPart);
            }
        });
    });
    return sum;
}


Foam::scalar Foam::fsi::contactBodies::share
(
    const surfaceSet& surfaces,
    const label objecti,
    const contactPair& pair,
    const label k
) const
{
    const label own = surfaces.pointObject()[pair.node];
    const bool face = pair.face >= 0 && pair.faceOwner(own) == objecti;
    scalar sum = own == objecti ? mode(pair.node, k) & pair.normal : 0;
    for (label i = 0; face && i < surfaces.nNodes(); ++i)
    {
        sum -= mode(surfaces.faces()[pair.face][i], k) & pair.share(i);
    }
    return sum;
}


Foam::scalar Foam::fsi::contactBodies::restDistance
(
    const surfaceSet& surfaces,
    const contactPair& pair
) const
{
    const pointField* rest = bodies_[pair.other].rest;
    if (!rest)
    {
        return GREAT;
    }
    const label start = surfaces.pointStart()[pair.other];
    const surfaceFace& f = surfaces.faces()[pair.face];
    vector distance((*rest)[pair.node - start]);
    for (label i = 0; i < surfaces.nNodes(); ++i)
    {
        distance -= pair.weights[i]*(*rest)[f[i] - start];
    }
    return mag(distance);
}


Foam::scalarField Foam::fsi::contactBodies::nodeAreas
(
    const pointField& points,
    const List<surfaceFace>& faces,
    const direction nDims,
    const scalar thickness
)
{
    surfaceSet surface(nDims);
    surface.append(points, faces);

    scalarField areas(points.size(), Zero);
    forAll(faces, facei)
    {
        const scalar share =
            mag(surface.areaNormal(facei))*(nDims == 2 ? thickness : 1)/nDims;
        for (label i = 0; i < nDims; ++i)
        {
            areas[faces[facei][i]] += share;
        }
    }
    return areas;
}


// ************************************************************************* //
