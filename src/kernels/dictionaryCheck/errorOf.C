// SPDX-License-Identifier: GPL-3.0-or-later

#include "errorOf.H"
#include "noTraps.H"

#include <cmath>
#include <new>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

int Foam::fsi::thrownErrors::depth_ = 0;

//- Handler that operator new calls outside errorOf: OpenFOAM's, which aborts
static std::new_handler handlerBefore = nullptr;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::thrownErrors::thrownErrors()
{
    if (depth_ == 0)
    {
        handlerBefore = std::set_new_handler(nullptr);
    }
    ++depth_;
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
}


Foam::fsi::thrownErrors::~thrownErrors()
{
    --depth_;
    if (depth_ == 0)
    {
        FatalError.dontThrowExceptions();
        FatalIOError.dontThrowExceptions();
        std::set_new_handler(handlerBefore);
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::caughtError Foam::fsi::errorOf(const std::function<void()>& code)
{
    // Numbers that do not fit become infinite; values are checked behind
    const noTraps untrapped;
    const thrownErrors thrown;
    caughtError caught;
    try
    {
        code();
    }
    catch (const IOerror& error)
    {
        caught.message = error.message();
        caught.file = error.ioFileName();
        caught.line = error.ioStartLineNumber();
    }
    catch (const error& error)
    {
        caught.message = error.message();
    }
    catch (const std::bad_alloc&)
    {
        caught.message = "more memory is asked for than there is";
    }
    catch (const std::exception& error)
    {
        caught.message = error.what();
    }
    return caught;
}


bool Foam::fsi::isUsable(const scalar value)
{
    // A comparison with NaN may be trapped
    return std::isfinite(value) && mag(value) < GREAT;
}


bool Foam::fsi::isUsable(const vector& value)
{
    return isUsable(value.x()) && isUsable(value.y()) && isUsable(value.z());
}


bool Foam::fsi::isEmptyList(const dictionary& dict, const word& key)
{
    const ITstream& is = dict.lookup(key);
    return is.size() == 1 && is[0].isLabel() && is[0].labelToken() == 0;
}


void Foam::fsi::checkValues
(
    const dictionary& dict,
    const word& key,
    const UList<scalar>& values
)
{
    for (const scalar value : values)
    {
        if (!isUsable(value))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' in dictionary " << dict.name()
                << " has the value " << value << " but all must be < 1e15"
                << exit(FatalIOError);
        }
    }
}


void Foam::fsi::checkValue
(
    const dictionary& dict,
    const word& key,
    const scalar& value
)
{
    checkValues(dict, key, UList<scalar>(const_cast<scalar*>(&value), 1));
}


// ************************************************************************* //
