// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphere.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(sphere, 0);
    addToRunTimeSelectionTable(shape, sphere, solid);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::sphere::sphere(const dictionary& dict)
:
    radius_(readPositive(dict, "radius"))
{
    checkKeys(dict, {"type", "radius"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::sphere::surface() const
{
    return sphereImage([this](const vector& n) { return radius_*n; });
}


Foam::scalar Foam::fsi::sphere::volume() const
{
    return 4.0/3*constant::mathematical::pi*pow3(radius_);
}


// ************************************************************************* //
