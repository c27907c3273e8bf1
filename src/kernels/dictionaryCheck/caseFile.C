// SPDX-License-Identifier: GPL-3.0-or-later

#include "caseFile.H"
#include "openfoamVersion.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::fsi::readCaseFile(const dictionary& dict, const word& key)
{
    fileName file(getEntry<fileName>(dict, key));
    // The Foundation's expand() does not know this name
    const std::string inCase("<case>/");
    if (file.compare(0, inCase.size(), inCase) == 0)
    {
        file = getEnv("FOAM_CASE")/file.substr(inCase.size());
    }
    file.expand();
    return file.isAbsolute() ? file : getEnv("FOAM_CASE")/file;
}


// ************************************************************************* //
