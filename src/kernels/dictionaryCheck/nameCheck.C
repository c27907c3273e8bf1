// SPDX-License-Identifier: GPL-3.0-or-later

#include "nameCheck.H"

#include <algorithm>
#include <cctype>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::checkName(const dictionary& dict, const word& name)
{
    const bool printable = std::all_of
    (
        name.begin(),
        name.end(),
        [](const unsigned char c)
        {
            // Letters of other alphabets are above 127
            return
                std::isalnum(c) || c > 127
             || c == '_' || c == '+' || c == '-';
        }
    );
    if (name.empty() || !printable)
    {
        FatalIOErrorInFunction(dict)
            << "The name '" << name << "' in dictionary " << dict.name()
            << " must consist of letters, digits and the characters _ + -:"
            << " files and columns are named so" << exit(FatalIOError);
    }
}


// ************************************************************************* //
