// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidVelocity.H"
#include "levelSetUpdate.H"
#include "objectMeans.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::setSolidVelocity
(
    const interfaceGeometry& geometry,
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces,
    volVectorField& U
)
{
    const vectorField& C = U.mesh().C();
    const boolList& fluid = geometry.fluidCell();

    // Mean velocity of each object's nodes, for cells far from its surface
    const vectorField mean(objectMeans(surfaces, surfaces.velocities()));

    FixedList<scalar, 3> weights;
    forAll(fluid, celli)
    {
        if (fluid[celli])
        {
            continue;
        }
        const label here = geometry.grid().haloIndex()[celli];
        const label facei = levelSet.nearestFace(here);
        if (facei >= 0)
        {
            surfaces.nearestOnFace(facei, C[celli], weights);
            U[celli] =
                surfaces.interpolate(surfaces.velocities(), facei, weights);
        }
        else if (levelSet.objectAt(here) >= 0)
        {
            U[celli] = mean[levelSet.objectAt(here)];
        }
    }
    U.correctBoundaryConditions();
}


// ************************************************************************* //
