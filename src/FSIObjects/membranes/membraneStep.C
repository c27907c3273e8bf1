// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneStep.H"
#include "deltaKernel.H"
#include "immersedMembranes.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::membraneForceStep Foam::fsi::membraneStepOf
(
    const fsiObjects& objects,
    const scalar deltaT
)
{
    const label width = immersedMembranes::readKernel(objects);
    return
    {
        deltaT,
        objects.fluid().dynamicViscosity(),
        objects.grid().spacing(),
        width == 2 ? scalar(8.5) : scalar(17),
        width == 2 ? deltaKernel<2>::lag
      : width == 3 ? deltaKernel<3>::lag
      : deltaKernel<4>::lag
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
