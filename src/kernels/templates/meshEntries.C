// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshEntries.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "surfaceTools.H"

#include <set>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Labels of all members of a list, one after the other
template<class Labels>
static labelList flatten(const List<Labels>& lists)
{
    labelList flat(lists.size()*Labels().size());
    label next = 0;
    for (const Labels& labels : lists)
    {
        for (const label i : labels)
        {
            flat[next++] = i;
        }
    }
    return flat;
}


//- FatalIOError for an entry of a mesh
static void refuse
(
    const dictionary& dict,
    const word& key,
    const char* fault
)
{
    FatalIOErrorInFunction(dict)
        << "Entry '" << key << "' in dictionary " << dict.name() << " "
        << fault << exit(FatalIOError);
}


//- Corners, of which those behind are -1 in two dimensions: is one no node
template<class Labels>
static bool outOfRange
(
    const List<Labels>& lists,
    const label nDims,
    const label nNodes
)
{
    const label nCorners = Labels().size() - 3 + nDims;
    for (const Labels& labels : lists)
    {
        for (label i = 0; i < label(labels.size()); ++i)
        {
            const bool corner = i < nCorners;
            if
            (
                corner
              ? labels[i] < 0 || labels[i] >= nNodes
              : labels[i] != -1
            )
            {
                return true;
            }
        }
    }
    return false;
}


//- Has the surface an edge (in 2D a node) without faces on both sides
static bool open(const shapeMesh& mesh, const label nDims)
{
    std::set<std::pair<label, label>> edges;
    std::set<label> starts, ends;
    for (const surfaceFace& face : mesh.faces)
    {
        if (nDims == 2)
        {
            if (!starts.insert(face[0]).second || !ends.insert(face[1]).second)
            {
                return true;
            }
            continue;
        }
        for (label i = 0; i < 3; ++i)
        {
            if (!edges.emplace(face[i], face[(i + 1) % 3]).second)
            {
                return true;
            }
        }
    }
    for (const auto& e : edges)
    {
        if (!edges.count({e.second, e.first}))
        {
            return true;
        }
    }
    return starts != ends;
}


//- Area or volume within the faces, < 0 if they are turned over [m2, m3]
static scalar inside(const shapeMesh& mesh, const label nDims)
{
    if (nDims == 3)
    {
        return surfaceTools::volume(mesh.points, mesh.faces);
    }
    scalar twice = 0;
    for (const surfaceFace& face : mesh.faces)
    {
        const point& origin = mesh.points[0];
        twice +=
        (
            (mesh.points[face[0]] - origin)^(mesh.points[face[1]] - origin)
        ).z();
    }
    return 0.5*twice;
}


//- FatalIOError unless a mesh is one that a body can have
static void check(const dictionary& dict, const shapeMesh& mesh)
{
    const label nDims = mesh.nDims();
    const label nNodes = mesh.points.size();
    for (direction d = 0; d < 3; ++d)
    {
        checkValues(dict, "points", mesh.points.component(d)());
    }
    if (mesh.nBoundary <= nDims || mesh.nBoundary > nNodes)
    {
        refuse(dict, "nBoundaryNodes", "is no number of nodes of 'points'");
    }
    if
    (
        mesh.faces.size() <= nDims
     || outOfRange(mesh.faces, nDims, mesh.nBoundary)
     || open(mesh, nDims)
    )
    {
        refuse(dict, "faces", "is no closed surface of the boundary nodes");
    }
    if (!(inside(mesh, nDims) > 0))
    {
        refuse(dict, "faces", "is turned over: nothing is inside");
    }
    if
    (
        outOfRange(mesh.elements, nDims, nNodes)
     || (mesh.elements.size() && !(min(mesh.elementVolumes()) > 0))
    )
    {
        refuse(dict, "elements", "has an element that is turned over or whose"
            " corners are no nodes");
    }
}


//- The inverse of flatten
template<class Labels>
static List<Labels> unflatten(const dictionary& dict, const word& key)
{
    const labelList flat(readEntry<labelList>(dict, key));
    if (flat.size() % Labels().size())
    {
        refuse(dict, key, "has not all labels of its last member");
    }
    List<Labels> lists(flat.size()/Labels().size());

    label next = 0;
    for (Labels& labels : lists)
    {
        for (label& i : labels)
        {
            i = flat[next++];
        }
    }
    return lists;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::readMesh(const dictionary& dict)
{
    shapeMesh mesh;
    mesh.points = readEntry<pointField>(dict, "points");
    mesh.nBoundary = getEntry<label>(dict, "nBoundaryNodes");
    mesh.faces = unflatten<surfaceFace>(dict, "faces");
    mesh.elements = unflatten<bodyElement>(dict, "elements");
    check(dict, mesh);
    return mesh;
}


void Foam::fsi::writeMesh(Ostream& os, const shapeMesh& mesh)
{
    putEntry(os, "nBoundaryNodes", mesh.nBoundary);
    putList(os, "points", mesh.points);
    putList(os, "faces", flatten(mesh.faces));
    putList(os, "elements", flatten(mesh.elements));
}


// ************************************************************************* //
