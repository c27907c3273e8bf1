// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceDepth.H"
#include "triangleProjection.H"
#include "triangleTree.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

struct Foam::fsi::surfaceDepth::treeOfFaces
{
    const triangleTree::triangleList triangles;
    const triangleTree::searchTree tree;

    explicit treeOfFaces(const shapeMesh& surface)
    :
        triangles(triangleTree::trianglesOf(surface)),
        tree(triangles.begin(), triangles.end())
    {}
};


namespace
{

//- A search in the tree: into boxes that are nearer by 1 % than what was found
template<class Distance>
struct depthSearch
{
    const Distance& distanceSqr;
    Foam::scalar nearest;

    bool go_further() const
    {
        return true;
    }

    template<class Query, class Primitive>
    void intersection(const Query&, const Primitive& face)
    {
        nearest = Foam::min(nearest, distanceSqr(face.id()));
    }

    template<class Query, class Node>
    bool do_intersect(const Query& p, const Node& node) const
    {
        const auto box = node.bbox();
        Foam::scalar sum = 0;
        for (int d = 0; d < 3; ++d)
        {
            const Foam::scalar outside = Foam::max
            (
                Foam::max(box.min(d) - p[d], p[d] - box.max(d)),
                Foam::scalar(0)
            );
            sum += outside*outside;
        }
        return 1.02*sum < nearest;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::surfaceDepth::distanceSqr
(
    const label facei,
    const point& p
) const
{
    const surfaceFace& f = surface_.faces[facei];
    return triangleProjection
    (
        surface_.points[f[0]], surface_.points[f[1]], surface_.points[f[2]]
    ).distanceSqr(p);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceDepth::surfaceDepth(const shapeMesh& surface)
:
    surface_(surface),
    tree_(std::make_shared<const treeOfFaces>(surface))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::surfaceDepth::operator()(const point& p) const
{
    const auto ofFace = [&](const triangleTree::triangleList::const_iterator& i)
    {
        return distanceSqr(i - tree_->triangles.begin(), p);
    };

    // The nearest of some faces, so that few boxes are nearer
    scalar nearest = GREAT;
    const label step = 1 + surface_.faces.size()/64;
    for (label facei = 0; facei < surface_.faces.size(); facei += step)
    {
        nearest = min(nearest, distanceSqr(facei, p));
    }
    depthSearch<decltype(ofFace)> search{ofFace, nearest};
    tree_->tree.traversal(triangleTree::toCgal(p), search);
    return sqrt(search.nearest);
}


// ************************************************************************* //
