// SPDX-License-Identifier: GPL-3.0-or-later

#include "readBetween.H"
#include "errorOf.H"

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


Foam::scalar Foam::fsi::readScalarBetween
(
    const dictionary& dict,
    const word& key,
    const scalar defaultValue,
    const scalar minimum,
    const scalar maximum
)
{
    const scalar value = dict.lookupOrDefault<scalar>(key, defaultValue);
    if (!(value >= minimum && value <= maximum))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " but must be from " << minimum << " to " << maximum
            << exit(FatalIOError);
    }
    return value;
}


Foam::vector Foam::fsi::readFinite
(
    const dictionary& dict,
    const word& key,
    const vector& defaultValue
)
{
    return dict.found(key) ? readFinite(dict, key) : defaultValue;
}


Foam::vector Foam::fsi::readFinite(const dictionary& dict, const word& key)
{
    const vector value(dict.get<vector>(key));
    checkValues(dict, key, UList<scalar>(const_cast<scalar*>(value.v_), 3));
    return value;
}


// ************************************************************************* //
