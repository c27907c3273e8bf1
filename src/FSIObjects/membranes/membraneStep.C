// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneStep.H"
#include "immersedBodies.H"
#include "immersedMembranes.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Largest dt a/(mu h) of explicit forces
static scalar stepLimit(const fsiObjects& objects)
{
    return immersedMembranes::readKernel(objects) == 2 ? 17 : 34;
}


//- Longest step of a group [s]
static scalar longestOf(const fsiObjects& objects, const bodyGroup& group)
{
    return
        stepLimit(objects)
       *objects.fluid().dynamicViscosity()*objects.grid().spacing()
       /dynamic_cast<const immersedBodies&>(group).stiffness();
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::longestMembraneStep(const fsiObjects& objects)
{
    // All ranks have the same groups
    scalar longest = GREAT;
    bool any = false;
    for (const bodyGroup& group : objects.bodies().groups())
    {
        if (!group.hasWalls())
        {
            any = true;
            longest = min(longest, longestOf(objects, group));
        }
    }
    return any ? overRanks(longest, minOp<scalar>()) : longest;
}


void Foam::fsi::checkMembraneStep
(
    const fsiObjects& objects,
    const bodyGroup& group,
    const scalar deltaT
)
{
    const scalar longest = longestOf(objects, group);
    if (deltaT > longest)
    {
        FatalErrorInFunction
            << "The time step " << deltaT << " s is too long for the membranes"
            << " of shape " << group.shape().name() << ": dt a/(mu h) is "
            << stepLimit(objects)*deltaT/longest << " but must be "
            << stepLimit(objects) << " at most, with the largest modulus a of"
            << " the membranes as they are stretched" << nl
            << "Take a step of " << longest << " s or less, adjustTimeStep yes,"
            << " or a smaller areaModulus" << exit(FatalError);
    }
}


// ************************************************************************* //
