// SPDX-License-Identifier: GPL-3.0-or-later

#include "shortWaveStress.H"
#include "shortWaves.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- For all four nodes of each object that has free waves, and their friction:
//  action(object, four, friction)
template<class Action>
static void forShortWaves(const fsiSystem& system, const Action& action)
{
    if (system.shortWaveStress <= 0)
    {
        return;
    }
    const scalar viscosity = system.fluidDensity*system.viscosity;
    const scalar thickness = system.grid.thickness();
    forAll(system.objects.groups(), groupi)
    {
        const bodyGroup& group = system.objects.groups()[groupi];
        const shapeTemplate& shape = group.shape();
        if (!group.hasFreeWaves())
        {
            continue;
        }
        const auto all = shortWaves::all
        (
            shape.points(), shape.faces(), shape.nDims(), thickness
        );
        for (const shortWaves::fourNodes& four : all)
        {
            const scalar friction =
                system.shortWaveStress*four.friction(viscosity);
            for (label copyi = 0; copyi < group.size(); ++copyi)
            {
                action
                (
                    system.objects.objectIndex(groupi, copyi),
                    four,
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
        [&](const label objecti, const auto& four, const scalar friction)
        {
            links[objecti].push_back({four.nodes, four.difference, friction});
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
        [&](const label objecti, const auto& four, const scalar friction)
        {
            four.addForce(start[objecti], friction, v, force);
        }
    );
}


// ************************************************************************* //
