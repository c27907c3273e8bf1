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
        const vector b(mesh.points[f[1]] - a);
        const label n = f[2] < 0 ? 2 : 3;
        const scalar area =
            n == 2 ? mag(b) : mag(b ^ (mesh.points[f[2]] - a));
        sum += n*area;
        for (label i = 0; i < n; ++i)
        {
            masses[f[i]] += area;
        }
    }
    return mass*masses/sum;
}


// ************************************************************************* //
