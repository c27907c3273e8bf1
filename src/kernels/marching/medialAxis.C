// SPDX-License-Identifier: GPL-3.0-or-later

#include "medialAxis.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::medialAxis::addPoint
(
    const cartesianBlock& block,
    const labelVector& ijk,
    const direction dir,
    const scalarField& phi,
    const labelList& object
)
{
    const label a = block.index(ijk);
    const label b = a + block.stride(dir);
    if (object[a] < 0 || object[b] < 0 || object[a] == object[b])
    {
        return;
    }

    const scalar h = block.spacing();
    const scalar s = min(max(0.5*(h + phi[b] - phi[a]), 0.0), h);
    const scalar lower = min(phi[a], phi[b]);
    if (lower >= 0.5*contactDistance_)
    {
        return;
    }

    medialAxisPoint p;
    p.position = block.position(ijk);
    p.position[dir] += s;
    p.distance = 0.5*(phi[a] + phi[b]);
    p.object[0] = min(object[a], object[b]);
    p.object[1] = max(object[a], object[b]);
    points_.append(p);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::medialAxis::medialAxis
(
    const scalar contactDistance,
    const scalar spacing
)
:
    contactDistance_(contactDistance),
    exact_(spacing),
    march_(0.5*contactDistance, 1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::medialAxis::update
(
    const surfaceSet& surfaces,
    const cartesianBlock& block
)
{
    points_.clear();
    fields_.start(exact_, surfaces, block);
    if (!fields_.seeds.empty())
    {
        march_.march(block, fields_);
        update(block, fields_.phi, fields_.object);
    }
}


void Foam::fsi::medialAxis::update
(
    const cartesianBlock& block,
    const scalarField& phi,
    const labelList& object
)
{
    points_.clear();
    labelVector ijk;
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        labelVector n(block.n());
        --n[dir];
        for (ijk.z() = 0; ijk.z() < n.z(); ++ijk.z())
        {
            for (ijk.y() = 0; ijk.y() < n.y(); ++ijk.y())
            {
                for (ijk.x() = 0; ijk.x() < n.x(); ++ijk.x())
                {
                    addPoint(block, ijk, dir, phi, object);
                }
            }
        }
    }
}


// ************************************************************************* //
