// SPDX-License-Identifier: GPL-3.0-or-later

#include "biconcave.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(biconcave, 0);
    addToRunTimeSelectionTable(shape, biconcave, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::biconcave::biconcave(const dictionary& dict)
:
    radius_(readPositive(dict, "radius"))
{
    checkKeys(dict, {"type", "radius"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsi::biconcave::curve() const
{
    // With s = cos(t) the root is |sin(t)|, and its sign that of y
    return sample
    (
        [this](const scalar t)
        {
            const scalar s2 = sqr(std::cos(t));
            const scalar profile = 0.2072 + s2*(2.0026 - 1.1228*s2);
            return point
            (
                radius_*std::cos(t),
                0.5*radius_*std::sin(t)*profile,
                0
            );
        }
    );
}


// ************************************************************************* //
