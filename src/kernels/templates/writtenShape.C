// SPDX-License-Identifier: GPL-3.0-or-later

#include "writtenShape.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The field of an entry, which has this size
static scalarField readField
(
    const dictionary& dict,
    const word& key,
    const label size
)
{
    const scalarField values(readEntry<scalarField>(dict, key));
    if (values.size() != size)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " has "
            << values.size() << " values but must have " << size
            << exit(FatalIOError);
    }
    return values;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

const Foam::dictionary& Foam::fsi::writtenShape::checked
(
    const dictionary& dict
)
{
    checkKeys
    (
        dict,
        {
            "FoamFile", "name", "nDims", "thickness", "nodeSpacing",
            "material", "admm", "nBoundaryNodes", "points", "faces",
            "elements", "springConstants", "nodeMasses", "heldNodes",
            "heldStiffness", "followedNodes"
        }
    );
    checkSubDicts(dict, {"material", "admm", "followedNodes"});
    const label nDims = getEntry<label>(dict, "nDims");
    if (nDims != 2 && nDims != 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nDims' in dictionary " << dict.name() << " is "
            << nDims << " but must be 2 or 3" << exit(FatalIOError);
    }
    return dict;
}


Foam::scalarField Foam::fsi::writtenShape::springConstants
(
    const dictionary& dict,
    const label nSprings
)
{
    const scalarField constants(readField(dict, "springConstants", nSprings));
    checkValues(dict, "springConstants", constants);
    return constants;
}


Foam::scalarField Foam::fsi::writtenShape::nodeMasses
(
    const dictionary& dict,
    const label nNodes,
    const scalar mass,
    const bool allHaveMass
)
{
    const scalarField masses(readField(dict, "nodeMasses", nNodes));
    const scalar least = min(masses);
    if
    (
        (allHaveMass ? !(least > 0) : !(least >= 0))
     || !(mag(sum(masses) - mass) < 1e-6*mass)
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nodeMasses' in dictionary " << dict.name()
            << " has the sum " << sum(masses) << " and the least value "
            << least << ", but density, volume and thickness make " << mass
            << exit(FatalIOError);
    }
    return masses;
}


// ************************************************************************* //
