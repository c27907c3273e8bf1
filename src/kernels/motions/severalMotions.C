// SPDX-License-Identifier: GPL-3.0-or-later

#include "severalMotions.H"
#include "addToRunTimeSelectionTable.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(severalMotions, 0);
    addToRunTimeSelectionTable(bodyMotion, severalMotions, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::severalMotions::severalMotions(const dictionary& dict)
:
    bodyMotion(dict, {"motions"})
{
    for (const dictionary& part : getEntry<List<dictionary>>(dict, "motions"))
    {
        autoPtr<bodyMotion> motion(bodyMotion::New(part));
        if (!motion.valid() || part.found("pivot"))
        {
            FatalIOErrorInFunction(dict)
                << "A motion of 'motions' in dictionary " << dict.name()
                << " is " << (motion.valid() ? "with a pivot" : "free") << nl
                << "Let 'pivot' stand beside 'motions', for all of them, and "
                << "name a prescribed type" << exit(FatalIOError);
        }
        motions_.append(motion.ptr());
    }
    if (motions_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'motions' in dictionary " << dict.name() << " is empty"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::severalMotions::displacement(const scalar clock) const
{
    vector sum(Zero), shift, turn;
    for (const bodyMotion& motion : motions_)
    {
        motion.place(clock, shift, turn);
        sum += shift;
    }
    return sum;
}


Foam::vector Foam::fsi::severalMotions::rotation(const scalar clock) const
{
    vector sum(Zero), shift, turn;
    for (const bodyMotion& motion : motions_)
    {
        motion.place(clock, shift, turn);
        sum += turn;
    }
    return sum;
}



// ************************************************************************* //
