// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneMaterial.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The number in the entry restCurvature; false if it says `shape`
static bool readCurvature(const dictionary& dict, scalar& curvature)
{
    const word key("restCurvature");
    if (!dict.found(key))
    {
        return false;
    }

    const token value(dict.lookup(key));
    if (value.isNumber())
    {
        curvature = value.number();
        return true;
    }
    if (!value.isWord() || value.wordToken() != "shape")
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " but must be a number [1/m] or shape"
            << exit(FatalIOError);
    }
    return false;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneMaterial::membraneMaterial(const dictionary& dict)
:
    stretchingModulus(readPositive(dict, "stretchingModulus")),
    bendingModulus(readNonNegative(dict, "bendingModulus", 0)),
    innerViscosity(readPositive(dict, "innerViscosity")),
    shapeCurvature(true),
    restCurvature(0)
{
    checkKeys
    (
        dict,
        {
            "type",
            "density",
            "stretchingModulus",
            "bendingModulus",
            "innerViscosity",
            "restCurvature"
        }
    );
    shapeCurvature = !readCurvature(dict, restCurvature);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::membraneMaterial::chosen(const dictionary& dict)
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


Foam::scalarField Foam::fsi::membraneMaterial::springConstants
(
    const shapeMesh& mesh,
    const scalarField& restLengths,
    const scalar thickness
) const
{
    forAll(mesh.faces, i)
    {
        const surfaceFace& face = mesh.faces[i];
        if (face[0] != i || face[1] != (i + 1) % mesh.faces.size())
        {
            FatalErrorInFunction
                << "The boundary nodes of a membrane are not one outline in"
                << " order" << exit(FatalError);
        }
    }
    return stretchingModulus*thickness/restLengths;
}


Foam::scalar Foam::fsi::membraneMaterial::youngsModulus
(
    const scalar area
) const
{
    return stretchingModulus/std::sqrt(area/constant::mathematical::pi);
}


// ************************************************************************* //
