// SPDX-License-Identifier: GPL-3.0-or-later

#include "caseFile.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::fsi::readCaseFile(const dictionary& dict, const word& key)
{
    fileName file(dict.get<fileName>(key));
    file.expand();
    return file.isAbsolute() ? file : getEnv("FOAM_CASE")/file;
}


// ************************************************************************* //
