// SPDX-License-Identifier: GPL-3.0-or-later

#include "readBetween.H"
#include "errorOf.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

template<class Type>
static Type readInRange
(
    const dictionary& dict,
    const word& key,
    const Type defaultValue,
    const Type minimum,
    const Type maximum
)
{
    const Type value = readEntryOr<Type>(dict, key, defaultValue);
    if (!(value >= minimum && value <= maximum))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " but must be from " << minimum << " to " << maximum
            << exit(FatalIOError);
    }
    return value;
}

} // End namespace fsi
} // End namespace Foam


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
    return readInRange(dict, key, defaultValue, minimum, maximum);
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
    return readInRange(dict, key, defaultValue, minimum, maximum);
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
    const vector value(readEntry<vector>(dict, key));
    checkValues(dict, key, UList<scalar>(const_cast<scalar*>(value.v_), 3));
    return value;
}


// ************************************************************************* //
