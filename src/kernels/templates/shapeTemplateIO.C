// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
#include "meshEntries.H"
#include "openfoamVersion.H"
#include "writtenShape.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::shapeTemplate::write(Ostream& os) const
{
    const int oldPrecision = os.precision(17);

    putEntry(os, "name", name_);
    putEntry(os, "nDims", label(nDims_));
    putEntry(os, "thickness", thickness_);
    putEntry(os, "nodeSpacing", nodeSpacing_);
    putDict(os, "material", materialDict_);
    if (elastic_.valid())
    {
        admm_.write(os);
    }
    writeMesh(os, mesh_);
    putList(os, "springConstants", springConstants_);
    putList(os, "nodeMasses", nodeMasses_);
    held_.write(os);
    followed_.write(os);

    os.precision(oldPrecision);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shapeTemplate::shapeTemplate(const dictionary& written)
:
    shapeTemplate
    (
        getEntry<word>(writtenShape::checked(written), "name"),
        written,
        readMesh(written),
        readPositive(written, "nodeSpacing"),
        readPositive(written, "thickness"),
        direction(getEntry<label>(written, "nDims")),
        false,
        point(0, 0, 0)
    )
{
    springConstants_ = writtenShape::springConstants(written, springs_.size());
    nodeMasses_ = writtenShape::nodeMasses
    (
        written, nNodes(), mass(), elements().size()
    );
}


// ************************************************************************* //
