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
static void forShortWaves
(
    const population& bodies,
    const fluidProperties& fluid,
    const scalar thickness,
    const scalarField& relative,
    const Action& action
)
{
    if (fluid.shortWaveStress <= 0)
    {
        return;
    }
    forAll(bodies.groups(), groupi)
    {
        const bodyGroup& group = bodies.groups()[groupi];
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
                fluid.shortWaveStress*four.friction(fluid.dynamicViscosity());
            for (label copyi = 0; copyi < group.size(); ++copyi)
            {
                const label objecti = bodies.objectIndex(groupi, copyi);
                action
                (
                    objecti,
                    four,
                    relative.empty() ? friction : friction*relative[objecti]
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
    const population& bodies,
    const fluidProperties& fluid,
    const scalar thickness,
    const scalarField& relative,
    viscousResponse::copyLinks& links
)
{
    forShortWaves
    (
        bodies,
        fluid,
        thickness,
        relative,
        [&](const label objecti, const auto& four, const scalar friction)
        {
            links[objecti].push_back({four.nodes, four.difference, friction});
        }
    );
}


void Foam::fsi::addShortWaveForce
(
    const population& bodies,
    const fluidProperties& fluid,
    const scalar thickness,
    const scalarField& relative,
    const vectorField& v,
    vectorField& force
)
{
    const labelList& start = bodies.surfaces().pointStart();
    forShortWaves
    (
        bodies,
        fluid,
        thickness,
        relative,
        [&](const label objecti, const auto& four, const scalar friction)
        {
            four.addForce(start[objecti], friction, v, force);
        }
    );
}


// ************************************************************************* //
