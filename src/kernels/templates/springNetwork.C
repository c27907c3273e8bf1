// SPDX-License-Identifier: GPL-3.0-or-later

#include "springNetwork.H"

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::edgeList Foam::fsi::springNetwork::springs
(
    const shapeMesh& mesh,
    const bool membrane
)
{
    if (!membrane)
    {
        return mesh.edges();
    }
    edgeList springs(mesh.faces.size());
    forAll(springs, i)
    {
        springs[i] = edge(mesh.faces[i][0], mesh.faces[i][1]);
    }
    return springs;
}


Foam::scalarField Foam::fsi::springNetwork::lengths
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const direction nDims
)
{
    scalarField lengths(springs.size());
    forAll(springs, springi)
    {
        const vector d =
            mesh.points[springs[springi][1]]
          - mesh.points[springs[springi][0]];
        scalar squares = 0;
        for (label i = 0; i < nDims; ++i)
        {
            squares += d[i]*d[i];
        }
        lengths[springi] = std::sqrt(squares);
    }
    return lengths;
}


// ************************************************************************* //
