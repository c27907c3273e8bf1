// SPDX-License-Identifier: GPL-3.0-or-later

#include "caseFile.H"
#include "openfoamVersion.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::fsi::readCaseFile(const dictionary& dict, const word& key)
{
    fileName file(getEntry<fileName>(dict, key));
    file.expand();
    return file.isAbsolute() ? file : getEnv("FOAM_CASE")/file;
}


// ************************************************************************* //
