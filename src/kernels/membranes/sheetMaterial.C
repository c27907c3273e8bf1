// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheetMaterial.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The law; FatalIOError for the modulus of earlier versions
static autoPtr<membraneLaw> newLaw(const dictionary& dict)
{
    const word old("stretchingModulus");
    if (dict.found(old))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << old << "' in dictionary " << dict.name()
            << " was the modulus of membranes with a filling, in two"
            << " dimensions; membranes are sheets inside the fluid now" << nl
            << "    For the same tension write shearModulus with a quarter of"
            << " its value (areaModulus is three quarters by default), and"
            << " restCurvature flat in place of 0" << exit(FatalIOError);
    }
    return membraneLaw::New(dict);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::sheetMaterial::sheetMaterial
(
    const dictionary& dict,
    const direction nDims
)
:
    law(newLaw(dict)),
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
    if (nDims == 2 && !law->ofSegments())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'law' in dictionary " << dict.name() << " is "
            << law->type() << ", which is for three dimensions; valid ones in"
            << " two dimensions are Skalak, neoHookean and drop"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::sheetMaterial> Foam::fsi::sheetMaterial::New
(
    const dictionary& dict,
    const direction nDims
)
{
    return autoPtr<sheetMaterial>
    (
        chosen(dict) ? new sheetMaterial(dict, nDims) : nullptr
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::sheetMaterial::chosen(const dictionary& dict)
{
    return
        readChoice
        (
            dict,
            "type",
            "elastic",
            {"elastic", "neoHookean", "membrane", "rigid"}
        )
     == "membrane";
}


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
