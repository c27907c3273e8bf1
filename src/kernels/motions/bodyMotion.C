// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"
#include "dictionaryCheck.H"
#include "openfoamFunction.H"
#include "openfoamVersion.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(bodyMotion, 0);
    defineRunTimeSelectionTable(bodyMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Rotation matrix of a rotation vector, less the unit matrix
static Foam::tensor turnOf(const Foam::vector& v)
{
    using namespace Foam;
    const scalar angle = mag(v);
    const vector axis(v/max(angle, VSMALL));
    const tensor across
    (
        0, -axis.z(), axis.y(),
        axis.z(), 0, -axis.x(),
        -axis.y(), axis.x(), 0
    );
    return
        std::sin(angle)*across
      + 2*sqr(std::sin(0.5*angle))*(across & across);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyMotion::bodyMotion(const dictionary& dict, wordList keys)
:
    pivot_(readFinite(dict, "pivot", Zero)),
    start_(readScalarBetween(dict, "start", 0, -GREAT, GREAT)),
    ramp_(readScalarBetween(dict, "ramp", 0, 0, GREAT))
{
    keys.append(wordList({"type", "pivot", "start", "ramp"}));
    checkKeys(dict, keys);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::bodyMotion> Foam::fsi::bodyMotion::New
(
    const dictionary& dict
)
{
    const word motionType(dict.lookupOrDefault<word>("type", "free"));
    if (motionType == "free")
    {
        // The solver reads them; a wrong one is to be found when seeding
        const wordList loads({"force", "torque"});
        for (const word& load : loads)
        {
            if (dict.found(load))
            {
                readFunction<vector>(dict, load);
            }
        }
        checkKeys(dict, {"type", loads[0], loads[1]});
        return autoPtr<bodyMotion>();
    }

    const auto* constructor =
        findIn(*dictionaryConstructorTablePtr_, motionType);
    if (!constructor)
    {
        wordList valid(dictionaryConstructorTablePtr_->sortedToc());
        valid.append("free");
        FatalIOErrorInFunction(dict)
            << "Unknown entry 'type' " << motionType << " in dictionary "
            << dict.name() << nl << "Valid motions are " << valid
            << exit(FatalIOError);
    }
    return (*constructor)(dict);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::bodyMotion::clock(const scalar time) const
{
    const scalar t = max(time - start_, scalar(0));
    return t < ramp_ ? 0.5*sqr(t)/ramp_ : t - 0.5*ramp_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyMotion::place
(
    const scalar time,
    vector& shift,
    vector& turn
) const
{
    shift = displacement(clock(time));
    turn = rotation(clock(time));
}


Foam::vector Foam::fsi::bodyMotion::shift
(
    const scalar from,
    const scalar to,
    const label nDims
) const
{
    vector start, end, turn;
    place(from, start, turn);
    place(to, end, turn);
    const vector arm(pivot_ + (this->turn(0, from, nDims) & pivot_));
    return end - start - (this->turn(from, to, nDims) & arm);
}


Foam::tensor Foam::fsi::bodyMotion::turn
(
    const scalar from,
    const scalar to,
    const label nDims
) const
{
    vector shift, start, end;
    place(from, shift, start);
    place(to, shift, end);
    if (nDims == 2)
    {
        start.x() = start.y() = end.x() = end.y() = 0;
    }
    if (mag(start ^ end) <= SMALL*mag(start)*mag(end))
    {
        // About one axis, exact for small angles too
        return turnOf(end - start);
    }
    const tensor first(turnOf(start)), last(turnOf(end));
    return ((last - first) & (tensor::I + first).T());
}


// ************************************************************************* //
