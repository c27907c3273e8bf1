// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceAlone.H"
#include "massPoints.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::withoutElements
(
    const shapeMesh& mesh,
    const direction nDims,
    const bool sheet
)
{
    if (!sheet)
    {
        return massPoints(mesh, nDims).mesh();
    }
    shapeMesh surface(mesh);
    surface.points.resize(surface.nBoundary);
    surface.elements.clear();
    return surface;
}


Foam::scalarField Foam::fsi::sheetMasses
(
    const shapeMesh& mesh,
    const scalar mass
)
{
    scalarField masses(mesh.points.size(), Zero);
    scalar sum = 0;
    for (const surfaceFace& f : mesh.faces)
    {
        const point& a = mesh.points[f[0]];
        const scalar area =
            mag((mesh.points[f[1]] - a) ^ (mesh.points[f[2]] - a));
        sum += 3*area;
        for (const label nodei : f)
        {
            masses[nodei] += area;
        }
    }
    return mass*masses/sum;
}


// ************************************************************************* //
