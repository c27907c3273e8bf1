// SPDX-License-Identifier: GPL-3.0-or-later

#include "ellipse.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(ellipse, 0);
    addToRunTimeSelectionTable(shape, ellipse, planar);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::ellipse::ellipse(const dictionary& dict)
:
    semiAxes_(readEntry<vector2D>(dict, "semiAxes"))
{
    checkKeys(dict, {"type", "semiAxes"});
    if (!(cmptMin(semiAxes_) > 1e-50 && cmptMax(semiAxes_) < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'semiAxes' in dictionary " << dict.name() << " is "
            << semiAxes_ << " but both must be > 0" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsi::ellipse::curve() const
{
    return sample
    (
        [this](const scalar t)
        {
            return point
            (
                semiAxes_.x()*std::cos(t),
                semiAxes_.y()*std::sin(t),
                0
            );
        }
    );
}


// ************************************************************************* //
