// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceOrder.H"
#include "openfoamVersion.H"
#include "nullBox.H"

#include <algorithm>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Number of edges from a node to each other one; as many as there are nodes if
//  there is no way
scalarField edgesFrom(const label start, const List<labelList>& neighbours)
{
    scalarField n(neighbours.size(), scalar(neighbours.size()));
    labelList front(1, start);
    n[start] = 0;
    for (scalar next = 1; front.size(); ++next)
    {
        DynamicList<label> reached;
        for (const label nodei : front)
        {
            for (const label neighbour : neighbours[nodei])
            {
                if (n[neighbour] > next)
                {
                    n[neighbour] = next;
                    reached.append(neighbour);
                }
            }
        }
        front = reached;
    }
    return n;
}


//- Places of nodes in a space in which neighbours are near to each other: along
//  each direction how much nearer a node is to one end than to the other, by
//  edges. An end is far from all ends before
pointField placesOf
(
    const List<fsi::surfaceFace>& faces,
    const label nNodes
)
{
    List<labelList> neighbours(nNodes);
    for (const fsi::surfaceFace& f : faces)
    {
        for (const label a : f)
        {
            for (const label b : f)
            {
                if (a >= 0 && b >= 0 && a != b)
                {
                    neighbours[a].append(b);
                }
            }
        }
    }

    pointField places(nNodes, Zero);
    if (nNodes == 0)
    {
        return places;
    }
    scalarField toEnds(edgesFrom(0, neighbours));
    for (direction d = 0; d < 3; ++d)
    {
        const scalarField low(edgesFrom(findMax(toEnds), neighbours));
        const scalarField high(edgesFrom(findMax(low), neighbours));
        places.replace(d, high - low);
        toEnds = d == 0 ? low : scalarField(min(toEnds, low));
        toEnds = scalarField(min(toEnds, high));
    }
    return places;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::fsi::surfaceFace> Foam::fsi::faceOrder::localFaces
(
    const surfaceSet& surfaces,
    const label objecti
)
{
    const label start = surfaces.faceStart()[objecti];
    const label offset = surfaces.pointStart()[objecti];
    List<surfaceFace> faces(surfaces.faceStart()[objecti + 1] - start);
    forAll(faces, i)
    {
        faces[i] = surfaces.faces()[start + i];
        for (label j = 0; j < surfaces.nNodes(); ++j)
        {
            faces[i][j] -= offset;
        }
    }
    return faces;
}


void Foam::fsi::faceOrder::sortFaces(const pointField& centres)
{
    faces_ = identityList(centres.size());
    faceStart_ = labelList({0, faces_.size()});
    while (faces_.size() > groupSize*nGroups())
    {
        labelList finer(1, Zero);
        for (label group = 0; group < nGroups(); ++group)
        {
            const label begin = faceStart_[group];
            const label end = faceStart_[group + 1];
            const label middle = (begin + end)/2;
            boundBox box(nullBox());
            for (label i = begin; i < end; ++i)
            {
                extend(box, centres[faces_[i]]);
            }
            const vector size(box.span());
            const direction longest =
                size.x() >= size.y() && size.x() >= size.z()
              ? 0
              : (size.y() >= size.z() ? 1 : 2);
            std::nth_element
            (
                faces_.begin() + begin,
                faces_.begin() + middle,
                faces_.begin() + end,
                [&](const label a, const label b)
                {
                    return centres[a][longest] < centres[b][longest];
                }
            );
            finer.append(middle);
            finer.append(end);
        }
        faceStart_ = finer;
    }
}


void Foam::fsi::faceOrder::sortNodes(const label nNodes)
{
    std::vector<bool> taken(nNodes, false);
    nodes_.clear();
    nodeStart_ = labelList(1, Zero);
    for (label group = 0; group < nGroups(); ++group)
    {
        for (const label facei : faces(group))
        {
            for (const label nodei : given_[facei])
            {
                if (nodei >= 0 && !taken[nodei])
                {
                    taken[nodei] = true;
                    nodes_.append(nodei);
                }
            }
        }
        nodeStart_.append(nodes_.size());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::faceOrder::faceOrder
(
    const surfaceSet& surfaces,
    const label objecti
)
:
    given_(localFaces(surfaces, objecti))
{
    const label nNodes =
        surfaces.pointStart()[objecti + 1] - surfaces.pointStart()[objecti];
    const pointField places(placesOf(given_, nNodes));
    pointField centres(given_.size(), Zero);
    forAll(centres, facei)
    {
        for (label i = 0; i < surfaces.nNodes(); ++i)
        {
            centres[facei] += places[given_[facei][i]]/surfaces.nNodes();
        }
    }
    sortFaces(centres);
    sortNodes(nNodes);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::faceOrder::fits
(
    const surfaceSet& surfaces,
    const label objecti
) const
{
    const label start = surfaces.faceStart()[objecti];
    const label offset = surfaces.pointStart()[objecti];
    if (surfaces.faceStart()[objecti + 1] - start != given_.size())
    {
        return false;
    }
    forAll(given_, i)
    {
        const surfaceFace& f = surfaces.faces()[start + i];
        for (label j = 0; j < surfaces.nNodes(); ++j)
        {
            if (given_[i][j] != f[j] - offset)
            {
                return false;
            }
        }
    }
    return surfaces.pointStart()[objecti + 1] - offset == nodes_.size();
}


// ************************************************************************* //
