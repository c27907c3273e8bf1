// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
#include "meshEntries.H"
#include "writtenShape.H"

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
        writtenShape::checked(written).get<word>("name"),
        written,
        readMesh(written),
        readPositive(written, "nodeSpacing"),
        readPositive(written, "thickness"),
        direction(written.get<label>("nDims")),
        false
    )
{
    springConstants_ = writtenShape::springConstants(written, springs_.size());
    nodeMasses_ = writtenShape::nodeMasses
    (
        written, nNodes(), mass(), elements().size()
    );
}


Foam::fsi::shapeTemplate::shapeTemplate(Istream& is)
:
    shapeTemplate(dictionary(is))
{}


// ************************************************************************* //
