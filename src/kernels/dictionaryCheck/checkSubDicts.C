// SPDX-License-Identifier: GPL-3.0-or-later

#include "checkSubDicts.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::checkSubDicts(const dictionary& dict, const wordList& keys)
{
    for (const word& key : keys)
    {
        if (dict.found(key) && !dict.isDict(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' in dictionary " << dict.name()
                << " must be a dictionary: " << key << " { .. }"
                << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
