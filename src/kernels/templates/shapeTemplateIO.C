// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "meshEntries.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Fatal unless a field has the size
static void checkSize
(
    const dictionary& dict,
    const word& key,
    const label size,
    const label expected
)
{
    if (size != expected)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " has "
            << size << " values but must have " << expected
            << exit(FatalIOError);
    }
}


//- Check the keys and the dimensions before anything else is read
static const dictionary& checked(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "FoamFile", "name", "nDims", "thickness", "nodeSpacing",
            "material", "admm", "nBoundaryNodes", "points", "faces",
            "elements", "springConstants", "nodeMasses"
        }
    );
    checkSubDicts(dict, {"material", "admm"});
    const label nDims = dict.get<label>("nDims");
    if (nDims != 2 && nDims != 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nDims' in dictionary " << dict.name() << " is "
            << nDims << " but must be 2 or 3" << exit(FatalIOError);
    }
    return dict;
}


//- Fatal unless the masses are those of a body of this mass
static void checkMasses
(
    const dictionary& dict,
    const scalarField& masses,
    const scalar mass,
    const bool allHaveMass
)
{
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
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::shapeTemplate::write(Ostream& os) const
{
    const int oldPrecision = os.precision(17);

    os.writeEntry("name", name_);
    os.writeEntry("nDims", label(nDims_));
    os.writeEntry("thickness", thickness_);
    os.writeEntry("nodeSpacing", nodeSpacing_);
    materialDict_.writeEntry("material", os);
    if (!membrane_.valid() && !rigid_)
    {
        admm_.write(os);
    }
    writeMesh(os, mesh_);
    springConstants_.UList<scalar>::writeEntry("springConstants", os);
    nodeMasses_.UList<scalar>::writeEntry("nodeMasses", os);

    os.precision(oldPrecision);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shapeTemplate::shapeTemplate(const dictionary& written)
:
    shapeTemplate
    (
        checked(written).get<word>("name"),
        written,
        readMesh(written),
        readPositive(written, "nodeSpacing"),
        readPositive(written, "thickness"),
        direction(written.get<label>("nDims")),
        false
    )
{
    springConstants_ = readEntry<scalarField>(written, "springConstants");
    nodeMasses_ = readEntry<scalarField>(written, "nodeMasses");
    checkSize
    (
        written, "springConstants", springConstants_.size(), springs_.size()
    );
    checkSize(written, "nodeMasses", nodeMasses_.size(), nNodes());
    checkValues(written, "springConstants", springConstants_);
    checkMasses(written, nodeMasses_, mass(), elements().size());
}


Foam::fsi::shapeTemplate::shapeTemplate(Istream& is)
:
    shapeTemplate(dictionary(is))
{}


// ************************************************************************* //
