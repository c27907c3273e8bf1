// SPDX-License-Identifier: GPL-3.0-or-later

#include "oscillatingMotion.H"
#include "readBetween.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(oscillatingMotion, 0);
    addToRunTimeSelectionTable(bodyMotion, oscillatingMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::oscillatingMotion::oscillatingMotion(const dictionary& dict)
:
    bodyMotion
    (
        dict, {"amplitude", "rotationAmplitude", "frequency", "phase"}
    ),
    amplitude_(readFinite(dict, "amplitude", Zero)),
    rotationAmplitude_(readFinite(dict, "rotationAmplitude", Zero)),
    frequency_(readPositive(dict, "frequency")),
    phase_(readScalarBetween(dict, "phase", 0, -GREAT, GREAT))
{
    if (!dict.found("amplitude") && !dict.found("rotationAmplitude"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'amplitude' or 'rotationAmplitude' must be in dictionary "
            << dict.name() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::oscillatingMotion::displacement
(
    const scalar clock
) const
{
    return sine(clock)*amplitude_;
}


Foam::vector Foam::fsi::oscillatingMotion::rotation(const scalar clock) const
{
    return sine(clock)*rotationAmplitude_;
}


Foam::scalar Foam::fsi::oscillatingMotion::sine(const scalar clock) const
{
    return std::sin(constant::mathematical::twoPi*frequency_*clock + phase_);
}


// ************************************************************************* //
