// SPDX-License-Identifier: GPL-3.0-or-later

#include "outlineLoop.H"
#include "Map.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fsi::outlineLoop
(
    const surfaceSet& surfaces,
    const label objecti
)
{
    const label start = surfaces.faceStart()[objecti];
    labelList nodes(surfaces.faceStart()[objecti + 1] - start);
    Map<label> next(2*nodes.size());
    forAll(nodes, i)
    {
        const surfaceFace& segment = surfaces.faces()[start + i];
        next.insert(segment[0], segment[1]);
    }

    label nodei = surfaces.faces()[start][0];
    for (label& node : nodes)
    {
        node = nodei;
        nodei = next[nodei];
    }
    return nodes;
}


// ************************************************************************* //
