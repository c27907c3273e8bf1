// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addLinkForce
(
    const fsiSystem& system,
    const volVectorField& U,
    const vectorField& v,
    vectorField& force
)
{
    const scalar viscosity = system.fluidDensity*system.viscosity;
    for (const wallLink& link : system.geometry.wallLinks())
    {
        const vector slip(U[link.cell] - link.place.interpolate(v));
        link.place.spread(force, viscosity*link.conductance*slip);
    }
}


void Foam::fsi::addTransposedForce
(
    const fsiSystem& system,
    const vectorField& v,
    vectorField& force
)
{
    const scalar viscosity =
        system.fluidDensity*system.viscosity*system.grid.thickness();
    for (const surfaceFace& face : system.objects.surfaces().faces())
    {
        const vector d = v[face[1]] - v[face[0]];
        const vector half = 0.5*viscosity*vector(-d.y(), d.x(), 0);
        force[face[0]] += half;
        force[face[1]] += half;
    }
}


// ************************************************************************* //
