// SPDX-License-Identifier: GPL-3.0-or-later

#include "errorOf.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

int Foam::fsi::thrownErrors::depth_ = 0;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::thrownErrors::thrownErrors()
{
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
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::caughtError Foam::fsi::errorOf(const std::function<void()>& code)
{
    const thrownErrors thrown;
    caughtError caught;
    try
    {
        code();
    }
    catch (const IOerror& error)
    {
        caught.message = error.message();
        caught.line = error.ioStartLineNumber();
    }
    catch (const error& error)
    {
        caught.message = error.message();
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


// ************************************************************************* //
