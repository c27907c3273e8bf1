// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "levelSetUpdate.H"
#include "objectMeans.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedFluid::immersedFluid
(
    const interfaceGeometry& geometry
)
:
    geometry_(geometry),
    faces_(geometry),
    rule_(geometry.grid().mesh()),
    gradient_(geometry),
    momentum_(geometry, rule_),
    flux_(geometry, faces_, rule_)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::fsi::immersedFluid::moved
(
    tmp<surfaceScalarField> tflux
)
{
    if (rule_.secondOrder() && flux_.moved().moved())
    {
        // Surfaces have moved to where they are expected
        tflux = newTmp<surfaceScalarField>("convectiveFlux", tflux());
        moveFlux(tflux.ref());
    }
    return tflux;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::immersedFluid::setSolidVelocity
(
    volVectorField& U,
    const surfaceSet& surfaces,
    const levelSetUpdate& levelSet
) const
{
    const vectorField& C = U.mesh().C();
    const boolList& fluid = geometry_.fluidCell();

    // Mean velocity of each object's nodes, for cells far from its surface
    const vectorField mean(objectMeans(surfaces, surfaces.velocities()));

    FixedList<scalar, 3> weights;
    forAll(fluid, celli)
    {
        if (fluid[celli])
        {
            continue;
        }
        const label here = geometry_.grid().haloIndex()[celli];
        const label facei = levelSet.nearestFace()[here];
        if (facei >= 0)
        {
            surfaces.nearestOnFace(facei, C[celli], weights);
            U[celli] =
                surfaces.interpolate(surfaces.velocities(), facei, weights);
        }
        else if (levelSet.object()[here] >= 0)
        {
            U[celli] = mean[levelSet.object()[here]];
        }
    }
    U.correctBoundaryConditions();
}


// ************************************************************************* //
