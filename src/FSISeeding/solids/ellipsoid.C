// SPDX-License-Identifier: GPL-3.0-or-later

#include "ellipsoid.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(ellipsoid, 0);
    addToRunTimeSelectionTable(shape, ellipsoid, solid);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::ellipsoid::ellipsoid(const dictionary& dict)
:
    semiAxes_(readLengths(dict, "semiAxes"))
{
    checkKeys(dict, {"type", "semiAxes"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::ellipsoid::surface() const
{
    return sphereImage
    (
        [this](const vector& n) { return cmptMultiply(semiAxes_, n); }
    );
}


Foam::scalar Foam::fsi::ellipsoid::volume() const
{
    return 4.0/3*constant::mathematical::pi*cmptProduct(semiAxes_);
}


// ************************************************************************* //
