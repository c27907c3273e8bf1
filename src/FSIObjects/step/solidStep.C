// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidStep.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(solidStep, 0);
    addToRunTimeSelectionTable(fsiStep, solidStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::solidStep::solidStep
(
    fsiObjects& objects,
    const flowFields& flow,
    const dictionary& dict
)
:
    fsiStep(objects),
    flow_(flow),
    rule_(objects.grid().mesh())
{
    checkKeys(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::solidStep::advance(const flowSources&)
{
    rule_.begin(flow_.U, flow_.phi);
    const stepLength step(rule_.length());

    feed();
    objects_.drive(flow_.U);
    if (rule_.secondOrder())
    {
        objects_.expect(rule_);
        objects_.moveLevelSet({});
    }
    predictAlone(objects_.forces(step), step);
    objects_.move(velocity_.groups(), step);
    objects_.moveLevelSet({&hydrodynamicForce_});
}


// ************************************************************************* //
