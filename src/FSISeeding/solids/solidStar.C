// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidStar.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(solidStar, 0);
    addNamedToRunTimeSelectionTable(shape, solidStar, solid, star);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::solidStar::solidStar(const dictionary& dict)
:
    section_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::solidStar::surface() const
{
    return sphereImage
    (
        [this](const vector& d)
        {
            const scalar wave =
                std::pow(std::hypot(d.x(), d.y()), section_.points())
               *std::cos(section_.points()*std::atan2(d.y(), d.x()));
            return section_.radius()*(1 + section_.amplitude()*wave)*d;
        }
    );
}


Foam::scalar Foam::fsi::solidStar::volume() const
{
    // Mean over directions of the square of the wave
    scalar square = 0.5;
    for (label k = 1; k <= section_.points(); ++k)
    {
        square *= 2*k/(2*k + 1.0);
    }
    return
        4.0/3*constant::mathematical::pi*pow3(section_.radius())
       *(1 + 3*sqr(section_.amplitude())*square);
}


// ************************************************************************* //
