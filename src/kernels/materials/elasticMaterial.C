// SPDX-License-Identifier: GPL-3.0-or-later

#include "elasticMaterial.H"
#include "dictionaryCheck.H"
#include "springCalibration.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Is the body neo-Hookean?
static bool isNeoHookean(const dictionary& material, const direction nDims)
{
    return
        material.lookupOrDefault<word>
        (
            "type", nDims == 3 ? "neoHookean" : "elastic"
        ) == "neoHookean";
}


//- Where strains are taken
static word readStrain(const dictionary& material, const direction nDims)
{
    const word element(nDims == 3 ? "element" : "triangle");
    return readChoice
    (
        material,
        "strain",
        nDims == 3 ? "nodalVolume" : "triangle",
        {element, "nodalVolume", "smoothed"}
    );
}


//- Viscosity of elements
static scalar readViscosity(const dictionary& material, const scalar kappa)
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


//- The sub-dictionary of the spring law; Hookean if there is none
static autoPtr<springLaw> newLaw(const dictionary& material, const scalar E)
{
    checkSubDicts(material, {"springLaw"});
    if (material.found("springLaw"))
    {
        return springLaw::New(material.subDict("springLaw"), E);
    }
    dictionary hookean;
    hookean.add("type", word("Hookean"));
    return springLaw::New(hookean, E);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::elasticMaterial::newShearModulus
(
    const dictionary& material
) const
{
    if (!neoHookean_)
    {
        return 0;
    }
    const scalar E = youngsModulus, kappa = areaStiffness;
    const bool solid = nDims_ == 3;
    if (kappa <= (solid ? 0.5*E : E))
    {
        FatalIOErrorInFunction(material)
            << "Entry 'areaStiffness' in dictionary " << material.name()
            << " is " << kappa << " Pa; a neo-Hookean body of E = " << E
            << " Pa needs more than " << (solid ? "E/2" : "E")
            << exit(FatalIOError);
    }
    return solid ? 3*kappa*E/(9*kappa - 2*E) : E*kappa/(4*kappa - 2*E);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::elasticMaterial::elasticMaterial
(
    const dictionary& material,
    const direction nDims
)
:
    nDims_(nDims),
    neoHookean_(isNeoHookean(material, nDims)),
    strain_(readStrain(material, nDims)),
    calibrated_
    (
        readChoice(material, "calibration", "patch", {"patch", "vanGelder"})
     == "patch"
    ),
    youngsModulus(readPositive(material, "E")),
    areaStiffness
    (
        readNonNegative(material, "areaStiffness", 10*youngsModulus)
    ),
    shearModulus(newShearModulus(material)),
    viscosity(readViscosity(material, areaStiffness)),
    law(newLaw(material, youngsModulus))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::elasticMaterial::checkEntries(const dictionary& material) const
{
    wordList keys
    ({
        "type", "density", "E", "areaStiffness", "strain", "viscosity"
    });
    if (!neoHookean_)
    {
        keys.append(wordList({"springLaw", "calibration"}));
    }
    checkKeys(material, keys);
}


Foam::autoPtr<Foam::fsi::volumeTerm>
Foam::fsi::elasticMaterial::newVolumeTerm
(
    const shapeMesh& mesh,
    const scalar thickness
) const
{
    typedef strainDomains::kind kind;
    const bool nodal = strain_ == "nodalVolume" || strain_ == "smoothed";
    return autoPtr<volumeTerm>
    (
        new volumeTerm
        (
            mesh,
            thickness,
            areaStiffness,
            shearModulus,
            nodal ? kind::node : kind::element,
            strain_ == "smoothed" ? kind::edge : kind::element
        )
    );
}


Foam::scalarField Foam::fsi::elasticMaterial::springConstants
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const volumeTerm& elementTerm,
    const scalar thickness
) const
{
    if (neoHookean_)
    {
        return scalarField(springs.size(), Zero);
    }
    if (calibrated_)
    {
        return springCalibration::calibrated
        (
            mesh, springs, elementTerm, thickness, youngsModulus
        );
    }
    return youngsModulus*springCalibration::vanGelder
    (
        mesh, springs, elementTerm.volumes()
    );
}


Foam::scalarField Foam::fsi::elasticMaterial::nodeMasses
(
    const shapeMesh& mesh,
    const volumeTerm& elementTerm,
    const scalar thickness,
    const scalar density
) const
{
    const scalarField& volumes = elementTerm.volumes();
    scalarField masses(mesh.points.size(), Zero);
    const label nCorners = nDims_ + 1;
    forAll(mesh.elements, elementi)
    {
        for (label i = 0; i < nCorners; ++i)
        {
            masses[mesh.elements[elementi][i]] +=
                density*volumes[elementi]/nCorners;
        }
    }
    return masses;
}


// ************************************************************************* //
