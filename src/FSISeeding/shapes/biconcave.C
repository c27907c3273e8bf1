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
    addToRunTimeSelectionTable(shape, biconcave, planar);
}
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::FixedList<Foam::scalar, 3>& Foam::fsi::biconcave::coefficients()
{
    static const FixedList<scalar, 3> values({0.2072, 2.0026, -1.1228});
    return values;
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
            return point
            (
                radius_*std::cos(t),
                0.5*radius_*std::sin(t)*profile(s2),
                0
            );
        }
    );
}


// ************************************************************************* //
