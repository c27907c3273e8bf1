// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneStep.H"
#include "immersedMembranes.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::membraneForceStep Foam::fsi::membraneStepOf
(
    const fsiObjects& objects,
    const scalar deltaT
)
{
    return
    {
        deltaT,
        objects.fluid().dynamicViscosity(),
        objects.grid().spacing(),
        immersedMembranes::readKernel(objects) == 2 ? scalar(8.5) : scalar(17)
    };
}


Foam::scalar Foam::fsi::longestMembraneStep(const fsiObjects& objects)
{
    // All ranks have the same groups
    const membraneForceStep unit(membraneStepOf(objects, 1));
    scalar longest = GREAT;
    bool any = false;
    for (const bodyGroup& group : objects.bodies().groups())
    {
        if (!group.hasWalls())
        {
            any = true;
            longest = min
            (
                longest,
                dynamic_cast<const immersedBodies&>(group).longestStep(unit)
            );
        }
    }
    return any ? overRanks(longest, minOp<scalar>()) : longest;
}


// ************************************************************************* //
