// SPDX-License-Identifier: GPL-3.0-or-later

#include "circle.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(circle, 0);
    addToRunTimeSelectionTable(shape, circle, planar);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::circle::circle(const dictionary& dict)
:
    radius_(readPositive(dict, "radius"))
{
    checkKeys(dict, {"type", "radius"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsi::circle::curve() const
{
    return sample
    (
        [this](const scalar t)
        {
            return point(radius_*std::cos(t), radius_*std::sin(t), 0);
        }
    );
}


// ************************************************************************* //
