// SPDX-License-Identifier: GPL-3.0-or-later

#include "shortWaveStress.H"
#include "shortWaves.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- For each row of nodes of the objects that have free waves, and its friction:
//  action(object, row, friction)
template<class Action>
static void forShortWaves(const fsiSystem& system, const Action& action)
{
    if (system.shortWaveStress <= 0)
    {
        return;
    }
    const scalar friction =
        system.shortWaveStress
       *shortWaves::friction
        (
            system.fluidDensity*system.viscosity,
            system.grid.thickness()
        );
    forAll(system.objects.groups(), groupi)
    {
        const bodyGroup& group = system.objects.groups()[groupi];
        if (!group.hasFreeWaves())
        {
            continue;
        }
        for (const auto& row : shortWaves::rows(group.shape()))
        {
            for (label copyi = 0; copyi < group.size(); ++copyi)
            {
                action
                (
                    system.objects.objectIndex(groupi, copyi),
                    row,
                    friction
                );
            }
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addShortWaves
(
    const fsiSystem& system,
    viscousResponse::copyLinks& links
)
{
    forShortWaves
    (
        system,
        [&](const label objecti, const auto& row, const scalar friction)
        {
            links[objecti].push_back({row, shortWaves::difference, friction});
        }
    );
}


void Foam::fsi::addShortWaveForce
(
    const fsiSystem& system,
    const vectorField& v,
    vectorField& force
)
{
    const labelList& start = system.objects.surfaces().pointStart();
    forShortWaves
    (
        system,
        [&](const label objecti, const auto& row, const scalar friction)
        {
            shortWaves::addForce(row, start[objecti], friction, v, force);
        }
    );
}


// ************************************************************************* //
