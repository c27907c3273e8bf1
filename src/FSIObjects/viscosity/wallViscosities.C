// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallViscosities.H"
#include "atFace.H"
#include "velocityGradient.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

//- Shear rate between the sides of a film at a distance
scalar slideRate
(
    const FixedList<filmSide, 2>& sides,
    const scalar distance,
    const vectorField& v
)
{
    return mag(sides[0].velocity(v) - sides[1].velocity(v))/distance;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::setWallViscosities
(
    viscosityLaw& law,
    const interfaceGeometry& geometry,
    const volTensorField& gradient,
    const volVectorField& U,
    const surfaceScalarField& phi,
    const vectorField& v,
    FixedList<scalarField, 3>& nu
)
{
    const cartesianMesh& grid = geometry.grid();
    DynamicList<scalar> rates;
    for (const wallLink& link : geometry.wallLinks())
    {
        rates.append
        (
            shearRate
            (
                gradientAtWall
                (
                    geometry, link, gradient[link.cell], U[link.cell], v
                )
            )
        );
    }
    law.viscosity(rates, nu[0]);

    rates.clear();
    for (const filmFace& film : geometry.films().faces())
    {
        const scalar area = grid.faceArea()*geometry.openness()[film.face];
        const scalar along = grid.faceAlong(film.face) ? 1 : -1;
        const scalar u = along*atFace(phi, film.face)/max(area, VSMALL);
        rates.append
        (
            Foam::hypot
            (
                6*(u - film.velocity(v))/film.gap,
                slideRate(film.sides, film.gap, v)
            )
        );
    }
    law.viscosity(rates, nu[1]);

    rates.clear();
    for (const filmLink& link : geometry.betweenSurfaces())
    {
        rates.append
        (
            slideRate(link.sides, grid.faceArea()/link.conductance, v)
        );
    }
    law.viscosity(rates, nu[2]);
}


// ************************************************************************* //
