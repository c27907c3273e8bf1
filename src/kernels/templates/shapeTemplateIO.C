// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
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
        written.get<word>("name"),
        written,
        readMesh(written),
        readPositive(written, "nodeSpacing"),
        readPositive(written, "thickness"),
        direction(written.get<label>("nDims")),
        false
    )
{
    springConstants_ = written.get<scalarField>("springConstants");
    nodeMasses_ = written.get<scalarField>("nodeMasses");
    checkSize
    (
        written, "springConstants", springConstants_.size(), springs_.size()
    );
    checkSize(written, "nodeMasses", nodeMasses_.size(), nNodes());
}


Foam::fsi::shapeTemplate::shapeTemplate(Istream& is)
:
    shapeTemplate(dictionary(is))
{}


// ************************************************************************* //
