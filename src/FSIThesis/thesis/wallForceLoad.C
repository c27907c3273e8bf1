// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallForceLoad.H"
#include "transposedStress.H"
#include "linkForces.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(wallForceLoad, 0);
    addToRunTimeSelectionTable(hydrodynamicLoad, wallForceLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::wallForceLoad::wallForceLoad(const fluidStep& step)
:
    hydrodynamicLoad(step)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallForceLoad::calculate
(
    const volScalarField& p,
    const volVectorField& U,
    const vectorField& wallVelocity,
    vectorField& force
) const
{
    const surfaceSet& surfaces = step_.objects().bodies().surfaces();
    const scalar density = step_.objects().fluid().density;
    const scalar viscosity = step_.objects().fluid().dynamicViscosity();
    partialForces links(wallVelocity.size());
    addLinkForce(step_.geometry(), viscosity, U, wallVelocity, links);
    force = links.collect(step_.objects().bodies().ranks());
    addTransposedForce
    (
        transposedModes
        (
            surfaces,
            step_.geometry(),
            viscosity*step_.objects().grid().thickness()
        ),
        surfaces.pointStart(),
        wallVelocity,
        force
    );

    vectorField pressureForce;
    step_.walls().transpose(p.primitiveField(), pressureForce);
    force += density*pressureForce;
    step_.walls().gradientForce
    (
        step_.gradients().openGradient(p)(),
        pressureForce
    );
    force += density*pressureForce;
}


// ************************************************************************* //
