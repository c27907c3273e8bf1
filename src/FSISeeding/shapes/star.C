// SPDX-License-Identifier: GPL-3.0-or-later

#include "star.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(star, 0);
    addToRunTimeSelectionTable(shape, star, planar);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::star::star(const dictionary& dict)
:
    radius_(readPositive(dict, "radius")),
    amplitude_(readPositive(dict, "amplitude", 0.3)),
    points_(readAtLeast(dict, "points", 5, 2))
{
    checkKeys(dict, {"type", "radius", "amplitude", "points"});
    if (amplitude_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'amplitude' in dictionary " << dict.name() << " is "
            << amplitude_ << " but must be < 1" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsi::star::curve() const
{
    return sample
    (
        [this](const scalar t)
        {
            const scalar r = radius_*(1 + amplitude_*std::cos(points_*t));
            return point(r*std::cos(t), r*std::sin(t), 0);
        }
    );
}


// ************************************************************************* //
