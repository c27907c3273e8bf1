// SPDX-License-Identifier: GPL-3.0-or-later

#include "rotations.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "mathematicalConstants.H"
#include "openfoamVersion.H"
#include "quaternion.H"
#include "randomNumbers.H"
#include "readBetween.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- [degrees]
static scalar readAngle(const dictionary& dict, const word& key)
{
    return readScalarBetween(dict, key, 0, -GREAT, GREAT);
}


//- Rotation from its dictionary
static tensor rotationFrom(const dictionary& dict)
{
    checkKeys(dict, {"axis", "angle", "quaternion"});
    if
    (
        dict.found("axis") == dict.found("quaternion")
     || dict.found("axis") != dict.found("angle")
    )
    {
        FatalIOErrorInFunction(dict)
            << "Dictionary " << dict.name() << " needs either the entries"
            << " 'axis' and 'angle' or the entry 'quaternion'"
            << exit(FatalIOError);
    }

    const bool byAxis = dict.found("axis");
    const word key(byAxis ? "axis" : "quaternion");
    const quaternion q
    (
        byAxis
      ? quaternion(0, readFinite(dict, "axis"))
      : readEntry<quaternion>(dict, "quaternion")
    );
    checkValues
    (
        dict, key, scalarList({q.w(), q.v().x(), q.v().y(), q.v().z()})
    );
    const scalar length = mag(q);
    if (!(length > 1e-50))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name()
            << " has the length " << length << " but must not be zero"
            << exit(FatalIOError);
    }
    return
        byAxis
      ? rotationAbout(q.v(), readAngle(dict, "angle"))
      : rotationOf(q.w(), q.v());
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tensor Foam::fsi::rotationAboutZ(const scalar degrees)
{
    const scalar c = cos(degToRad(degrees)), s = sin(degToRad(degrees));
    return tensor(c, -s, 0, s, c, 0, 0, 0, 1);
}


Foam::tensor Foam::fsi::rotationAbout
(
    const vector& axis,
    const scalar degrees
)
{
    const scalar half = 0.5*degToRad(degrees);
    return rotationOf(cos(half), sin(half)*axis/mag(axis));
}


Foam::tensor Foam::fsi::rotationXYZ(const vector& degrees)
{
    return
        rotationAbout(vector(0, 0, 1), degrees.z())
      & rotationAbout(vector(0, 1, 0), degrees.y())
      & rotationAbout(vector(1, 0, 0), degrees.x());
}


Foam::tensor Foam::fsi::rotationOf(const scalar w, const vector& xyz)
{
    const scalar length = sqrt(sqr(w) + magSqr(xyz));
    const scalar a = w/length;
    const vector v(xyz/length);
    return
        (sqr(a) - magSqr(v))*tensor::I + 2*(v*v)
      + 2*a*tensor(0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0);
}


Foam::tensor Foam::fsi::readRotation
(
    const dictionary& dict,
    const direction nDims
)
{
    if (!dict.isDict("rotation"))
    {
        return rotationAboutZ(readAngle(dict, "rotation"));
    }
    if (nDims == 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'rotation' in dictionary " << dict.name()
            << " must be a number in two dimensions, the angle about z in"
            << " degrees" << exit(FatalIOError);
    }
    return rotationFrom(dict.subDict("rotation"));
}


Foam::tensor Foam::fsi::randomRotation
(
    randomNumbers& random,
    const direction nDims
)
{
    if (nDims == 2)
    {
        return rotationAboutZ(360*random.sample01<scalar>());
    }
    const scalar part = random.sample01<scalar>();
    const scalar a = constant::mathematical::twoPi*random.sample01<scalar>();
    const scalar b = constant::mathematical::twoPi*random.sample01<scalar>();
    const scalar r = sqrt(1 - part), s = sqrt(part);
    return rotationOf(s*cos(b), vector(r*sin(a), r*cos(a), s*sin(b)));
}


Foam::tensor Foam::fsi::randomTurn
(
    randomNumbers& random,
    const direction nDims,
    const scalar degrees
)
{
    if (nDims == 2)
    {
        return rotationAboutZ(degrees);
    }
    vector axis(Zero);
    while (magSqr(axis) < SMALL)
    {
        axis = randomInBall(random, nDims);
    }
    return rotationAbout(axis, degrees);
}


Foam::vector Foam::fsi::randomInBall
(
    randomNumbers& random,
    const direction nDims
)
{
    vector v(Zero);
    do
    {
        for (direction d = 0; d < nDims; ++d)
        {
            v[d] = 2*random.sample01<scalar>() - 1;
        }
    }
    while (magSqr(v) > 1);
    return v;
}


// ************************************************************************* //
