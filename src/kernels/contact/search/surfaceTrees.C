// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceTrees.H"
#include "contactGeometry.H"
#include "openfoamVersion.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceTrees::updateTree
(
    const surfaceSet& surfaces,
    const contactGeometry& geometry,
    const label objecti
)
{
    const faceOrder& order = *orderOf_[objecti];
    const label nGroups = order.nGroups();
    const label faceStart = surfaces.faceStart()[objecti];
    branch* tree = branches_.data() + treeStart_[objecti];
    for (label group = 0; group < nGroups; ++group)
    {
        branch& b = tree[nGroups + group];
        b = branch();
        for (const label facei : order.faces(group))
        {
            const surfaceFace& f = surfaces.faces()[faceStart + facei];
            for (label i = 0; i < surfaces.nNodes(); ++i)
            {
                extend(b.places, surfaces.points()[f[i]]);
            }
            extend(b.normals, geometry.faceNormal(faceStart + facei));
        }
    }
    for (label i = nGroups - 1; i > 0; --i)
    {
        tree[i] = tree[2*i];
        extend(tree[i].places, tree[2*i + 1].places);
        extend(tree[i].normals, tree[2*i + 1].normals);
    }
}


void Foam::fsi::surfaceTrees::updateSpheres(const surfaceSet& surfaces)
{
    const pointField& x = surfaces.points();
    spheres_.setSize(surfaces.faces().size());
    forAll(spheres_, facei)
    {
        const surfaceFace& f = surfaces.faces()[facei];
        sphere& s = spheres_[facei];
        s.centre = x[f[0]];
        for (label i = 1; i < surfaces.nNodes(); ++i)
        {
            s.centre += x[f[i]];
        }
        s.centre /= surfaces.nNodes();
        scalar radiusSqr = 0;
        for (label i = 0; i < surfaces.nNodes(); ++i)
        {
            radiusSqr = max(radiusSqr, magSqr(x[f[i]] - s.centre));
        }
        s.radius = Foam::sqrt(radiusSqr);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::surfaceTrees::update
(
    const surfaceSet& surfaces,
    const contactGeometry& geometry
)
{
    orderOf_.setSize(surfaces.size());
    treeStart_.setSize(surfaces.size());
    label nBranches = 0;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const auto fits = [&](const std::unique_ptr<faceOrder>& order)
        {
            return order->fits(surfaces, objecti);
        };
        auto known = std::find_if(orders_.begin(), orders_.end(), fits);
        if (known == orders_.end())
        {
            orders_.push_back(std::make_unique<faceOrder>(surfaces, objecti));
            known = orders_.end() - 1;
        }
        orderOf_[objecti] = known->get();
        treeStart_[objecti] = nBranches;
        nBranches += 2*(*known)->nGroups();
    }
    if (branches_.size() < nBranches)
    {
        branches_.setSize(nBranches);
    }
    updateSpheres(surfaces);
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (surfaces.hasWalls(objecti))
        {
            updateTree(surfaces, geometry, objecti);
        }
    }
}


// ************************************************************************* //
