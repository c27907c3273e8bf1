// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshGrading.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::meshGrading::meshGrading(const dictionary& dict)
:
    growthRate_(readNonNegative(dict, "growthRate", 0.3)),
    evenDepth_(readNonNegative(dict, "evenDepth", 6))
{
    checkKeys(dict, {"growthRate", "evenDepth"});
    if (growthRate_ > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'growthRate' in dictionary " << dict.name() << " is "
            << growthRate_ << " but must be at most 1" << exit(FatalIOError);
    }
}


// ************************************************************************* //
