// SPDX-License-Identifier: GPL-3.0-or-later

#include "secondOrderStep.H"
#include "objectContact.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::beginSecondOrder
(
    fsiSystem& system,
    const couplingModel& coupling
)
{
    if
    (
        system.objects.size()
     && !(coupling.secondOrder() && system.levelSet->secondOrder())
    )
    {
        FatalIOErrorInFunction(system.properties)
            << "Coupling " << coupling.type() << " with level set "
            << system.levelSet->type() << " is of first order in time: take"
            << " Euler for ddtSchemes. Of second order are the couplings"
            << " solidImplicit and none with the level set rebuilt"
            << exit(FatalIOError);
    }
    system.contacts->keepStart();
    for (bodyGroup& group : system.objects.groups())
    {
        group.begin
        (
            system.grid.mesh().time().value(),
            system.deltaT(),
            system.fluid.rule().ratio()
        );
    }
    system.updateSurfaces();
}


// ************************************************************************* //
