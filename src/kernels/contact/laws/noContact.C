// SPDX-License-Identifier: GPL-3.0-or-later

#include "noContact.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(noContact, 0);
    addToRunTimeSelectionTable(contactLaw, noContact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::noContact::noContact(const dictionary& dict, const contactScales&)
{
    checkKeys(dict, {"type"});
}


// ************************************************************************* //
