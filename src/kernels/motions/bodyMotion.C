// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"
#include "dictionaryCheck.H"
#include "objectLoad.H"
#include "openfoamVersion.H"
#include "readBetween.H"
#include "readFunction.H"
#include "rigidTurn.H"

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

static Eigen::Vector3d toEigen(const Foam::vector& v)
{
    return Eigen::Vector3d(v.x(), v.y(), v.z());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyMotion::bodyMotion(const dictionary& dict, wordList keys)
:
    name_(dict.name()),
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
    const word motionType(readName(dict, "type", "free"));
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
        const wordList regions({"pulls", "loads"});
        const wordList freedoms({"translations", "rotations"});
        checkKeys
        (
            dict,
            {
                "type", loads[0], loads[1], regions[0], regions[1],
                freedoms[0], freedoms[1]
            }
        );
        checkSubDicts(dict, regions);
        for (const entry& e : dict.subOrEmptyDict(regions[0]))
        {
            if (e.isDict())
            {
                readFunction<vector>(e.dict(), loads[0]);
            }
        }
        objectLoad::newLoads(dict.subOrEmptyDict(regions[1]));
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


void Foam::fsi::bodyMotion::checkPlane
(
    const vector& shift,
    const vector& turn
) const
{
    if (shift.z() != 0 || turn.x() != 0 || turn.y() != 0)
    {
        FatalErrorInFunction
            << "The motion in dictionary " << name_ << " leaves the plane of"
            << " this case in two dimensions: displacement " << shift
            << " m, rotation vector " << turn << " rad" << nl
            << "Bodies move along x and y and turn about z only"
            << exit(FatalError);
    }
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


Eigen::Vector3d Foam::fsi::bodyMotion::shift
(
    const scalar from,
    const scalar to,
    const label nDims
) const
{
    vector start, end, rotation;
    place(from, start, rotation);
    place(to, end, rotation);
    if (nDims == 2)
    {
        checkPlane(end, rotation);
    }
    const Eigen::Vector3d pivot(toEigen(pivot_));
    const Eigen::Vector3d arm(pivot + turn(0, from)*pivot);
    return toEigen(end - start) - turn(from, to)*arm;
}


Eigen::Matrix3d Foam::fsi::bodyMotion::turn
(
    const scalar from,
    const scalar to
) const
{
    vector shift, start, end;
    place(from, shift, start);
    place(to, shift, end);
    if (mag(start ^ end) <= SMALL*mag(start)*mag(end))
    {
        // About one axis, exact for small angles too
        return exponentialLess1(toEigen(end - start));
    }
    const Eigen::Matrix3d first(exponentialLess1(toEigen(start)));
    const Eigen::Matrix3d change(exponentialLess1(toEigen(end)) - first);
    return change*(Eigen::Matrix3d::Identity() + first).transpose();
}


Foam::fsi::bodyMotion::rigidStep Foam::fsi::bodyMotion::between
(
    const scalar from,
    const scalar to,
    const label nDims
) const
{
    return
    {
        shift(from, to, nDims).head(nDims).transpose(),
        turn(from, to).topLeftCorner(nDims, nDims)
    };
}


// ************************************************************************* //
