// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyFreedom.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "wordList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Names of axes
static wordList namesOf(const bodyFreedom::axes& all)
{
    static const char names[] = "xyz";
    wordList result;
    for (const direction axis : all)
    {
        result.append(word(std::string(1, names[axis])));
    }
    return result;
}


//- Axes of a list that the dictionary has, in the order of the choices
static bodyFreedom::axes axesOf
(
    const dictionary& dict,
    const word& key,
    const wordList& given,
    const bodyFreedom::axes& all
)
{
    const wordList valid(namesOf(all));
    bodyFreedom::axes found;
    forAll(all, i)
    {
        if (isIn(given, valid[i]))
        {
            found.append(all[i]);
        }
    }
    if (found.size() != given.size())
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << flatOutput(given) << " but must be a list of some of "
            << flatOutput(valid) << ", each once" << exit(FatalIOError);
    }
    return found;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyFreedom::bodyFreedom(const label nDims)
:
    nDims_(nDims)
{
    for (direction d = 0; d < 3; ++d)
    {
        if (d < nDims)
        {
            translations_.append(d);
        }
        if (nDims == 3 || d == 2)
        {
            rotations_.append(d);
        }
    }
}


Foam::fsi::bodyFreedom::bodyFreedom
(
    const dictionary& motion,
    const label nDims
)
:
    bodyFreedom(nDims)
{
    const axes moves(translations_), turns(rotations_);
    const wordList given
    (
        readEntryOr<wordList>(motion, "translations", namesOf(moves))
    );
    const wordList about
    (
        readEntryOr<wordList>(motion, "rotations", namesOf(turns))
    );
    translations_ = axesOf(motion, "translations", given, moves);
    rotations_ = axesOf(motion, "rotations", about, turns);
    if (translations_.empty() && rotations_.empty())
    {
        FatalIOErrorInFunction(motion)
            << "Entries 'translations' and 'rotations' in dictionary "
            << motion.name() << " leave nothing free: take 'type fixed;'"
            << exit(FatalIOError);
    }
    if (rotations_.size() == 2)
    {
        FatalIOErrorInFunction(motion)
            << "Entry 'rotations' in dictionary " << motion.name()
            << " has two axes but must have none, one or all"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::bodyFreedom::allows
(
    const vector& velocity,
    const vector& angular
) const
{
    vector v(velocity), omega(angular);
    for (const direction d : translations_)
    {
        v[d] = 0;
    }
    for (const direction d : rotations_)
    {
        omega[d] = 0;
    }
    if (nDims_ == 2)
    {
        v.z() = omega.x() = omega.y() = 0;
    }
    return v == vector(Zero) && omega == vector(Zero);
}


// ************************************************************************* //
