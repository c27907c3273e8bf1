// SPDX-License-Identifier: GPL-3.0-or-later

#include "readBetween.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::readBetween
(
    const dictionary& dict,
    const word& key,
    const label defaultValue,
    const label minimum,
    const label maximum
)
{
    const label value = dict.lookupOrDefault<label>(key, defaultValue);
    if (value < minimum || value > maximum)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " but must be from " << minimum << " to " << maximum
            << exit(FatalIOError);
    }
    return value;
}


// ************************************************************************* //
