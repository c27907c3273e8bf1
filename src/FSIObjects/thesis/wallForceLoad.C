// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallForceLoad.H"
#include "transposedStress.H"
#include "linkForces.H"
#include "sumOverRanks.H"
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

Foam::fsi::wallForceLoad::wallForceLoad(const fsiSystem& system)
:
    hydrodynamicLoad(system)
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
    force.setSize(wallVelocity.size());
    force = Zero;
    addLinkForce(system_, U, wallVelocity, force);
    sumOverRanks(force);
    addTransposedForce
    (
        transposedModes(system_),
        system_.objects.surfaces().pointStart(),
        wallVelocity,
        force
    );

    vectorField pressureForce;
    system_.walls.transpose(p.primitiveField(), pressureForce);
    force += system_.fluidDensity*pressureForce;
    system_.walls.gradientForce
    (
        system_.fluid.openGradient(p)(),
        pressureForce
    );
    force += system_.fluidDensity*pressureForce;
}


// ************************************************************************* //
