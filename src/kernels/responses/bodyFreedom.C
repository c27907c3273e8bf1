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

//- Axes of an entry, in the order of the choices; all if there is none
static bodyFreedom::axes readAxes
(
    const dictionary& dict,
    const word& key,
    const bodyFreedom::axes& all
)
{
    if (!dict.found(key))
    {
        return all;
    }
    const wordList given(readEntry<wordList>(dict, key));
    static const char names[] = "xyz";
    bodyFreedom::axes found;
    wordList valid;
    for (const direction axis : all)
    {
        valid.append(word(std::string(1, names[axis])));
        if (isIn(given, valid.last()))
        {
            found.append(axis);
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
    translations_ = readAxes(motion, "translations", axes(translations_));
    rotations_ = readAxes(motion, "rotations", axes(rotations_));
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
