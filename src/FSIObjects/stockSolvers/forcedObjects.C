// SPDX-License-Identifier: GPL-3.0-or-later

#include "forcedObjects.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::forcedObjects::forcedObjects
(
    const fvMesh& mesh,
    const scalar viscosity
)
:
    objects_(mesh, viscosity, directForcing::select),
    forcing_(refCast<directForcing>(objects_.coupling())),
    timeIndex_(mesh.time().timeIndex())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::forcedObjects::advance
(
    volVectorField& U,
    volScalarField& p
)
{
    const Time& time = U.mesh().time();
    if (timeIndex_ != time.timeIndex())
    {
        timeIndex_ = time.timeIndex();
        forcing_.takeLoad(U.oldTime().primitiveField());
        objects_.startStep(p, U.oldTime());
        objects_.finishStep(p, U);
        forcing_.updateCoverage();
        objects_.write();
    }
}


void Foam::fsi::forcedObjects::force(fvVectorMatrix& UEqn)
{
    forcing_.force(UEqn);
}


// ************************************************************************* //
