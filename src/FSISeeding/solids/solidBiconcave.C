// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidBiconcave.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(solidBiconcave, 0);
    addNamedToRunTimeSelectionTable(shape, solidBiconcave, solid, biconcave);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::solidBiconcave::solidBiconcave(const dictionary& dict)
:
    section_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::solidBiconcave::surface() const
{
    return sphereImage
    (
        [this](const vector& d)
        {
            return section_.radius()*vector
            (
                d.x(),
                0.5*d.y()*biconcave::profile(sqr(d.x()) + sqr(d.z())),
                d.z()
            );
        }
    );
}


Foam::scalar Foam::fsi::solidBiconcave::volume() const
{
    const FixedList<scalar, 3>& c = biconcave::coefficients();
    return
        constant::mathematical::twoPi*pow3(section_.radius())
       *(c[0]/3 + c[1]*2/15 + c[2]*8/105);
}


// ************************************************************************* //
