// SPDX-License-Identifier: GPL-3.0-or-later

#include "elasticMaterial.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace elasticMaterial
{

//- Is the body neo-Hookean?
static bool neoHookean(const dictionary& material)
{
    return material.lookupOrDefault<word>("type", "elastic") == "neoHookean";
}

} // End namespace elasticMaterial
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::elasticMaterial::shearModulus
(
    const dictionary& material,
    const scalar E,
    const scalar kappa
)
{
    if (!neoHookean(material))
    {
        return 0;
    }
    if (kappa <= E)
    {
        FatalIOErrorInFunction(material)
            << "Entry 'areaStiffness' in dictionary " << material.name()
            << " is " << kappa << " Pa; a neo-Hookean body of E = " << E
            << " Pa needs more than E" << exit(FatalIOError);
    }
    return E*kappa/(4*kappa - 2*E);
}


Foam::scalar Foam::fsi::elasticMaterial::viscosity
(
    const dictionary& material,
    const scalar kappa
)
{
    const scalar viscosity = readNonNegative(material, "viscosity", 0);
    if (viscosity > 0 && !(kappa > 0))
    {
        FatalIOErrorInFunction(material)
            << "Entry 'viscosity' in dictionary " << material.name()
            << " needs an areaStiffness above 0" << exit(FatalIOError);
    }
    return viscosity;
}


void Foam::fsi::elasticMaterial::check
(
    const dictionary& dict,
    const bool membrane
)
{
    if (neoHookean(dict.subDict("material")))
    {
        checkKeys
        (
            dict.subDict("material"),
            {
                "type",
                "density",
                "E",
                "areaStiffness",
                "strain",
                "viscosity",
                "nodeMass"
            }
        );
    }
    else if (!membrane)
    {
        checkKeys
        (
            dict.subDict("material"),
            {
                "type",
                "density",
                "E",
                "springLaw",
                "areaStiffness",
                "strain",
                "viscosity",
                "calibration",
                "nodeMass"
            }
        );
    }
    else if (dict.found("admm"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'admm' in dictionary " << dict.name()
            << " has no meaning for a material of type membrane"
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
