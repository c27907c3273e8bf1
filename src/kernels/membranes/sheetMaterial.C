// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheetMaterial.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::sheetMaterial::sheetMaterial(const dictionary& dict)
:
    law(membraneLaw::New(dict)),
    shearModulus(law->modulus()),
    bendingModulus(readNonNegative(dict, "bendingModulus", 0)),
    flat
    (
        readChoice(dict, "restCurvature", "shape", {"shape", "flat"}) == "flat"
    ),
    innerViscosity
    (
        dict.found("innerViscosity") ? readPositive(dict, "innerViscosity") : 0
    ),
    membraneViscosity(readNonNegative(dict, "membraneViscosity", 0)),
    viscousModulus
    (
        membraneViscosity > 0 ? readPositive(dict, "viscousModulus") : 0
    )
{
    wordList known
    ({
        "type", "density", "law", "bendingModulus", "restCurvature",
        "innerViscosity", "membraneViscosity", "viscousModulus"
    });
    known.append(law->entries());
    checkKeys(dict, known);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::sheetMaterial::stiffness
(
    const scalar spacing,
    const scalar ratio
) const
{
    return
        shearModulus*(2 + pow(ratio, 0.75)*(law->areaModulus() - 1))
      + explicitStiffness(spacing);
}


Foam::scalar Foam::fsi::sheetMaterial::explicitStiffness
(
    const scalar spacing
) const
{
    return 2*(viscousModulus + bendingModulus/sqr(spacing));
}


// ************************************************************************* //
