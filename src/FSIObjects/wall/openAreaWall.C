// SPDX-License-Identifier: GPL-3.0-or-later

#include "openAreaWall.H"
#include "readBetween.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "openArea.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(openAreaWall, 0);
    addToRunTimeSelectionTable(wallTreatment, openAreaWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::openAreaWall::openAreaWall(const dictionary& dict)
:
    minWallDistance_(readScalarBetween(dict, "minWallDistance", 0.1, 1e-6, 1))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::openAreaWall::openness
(
    const FixedList<scalar, 4>& corners,
    const label nCorners,
    const scalar,
    const scalar
) const
{
    return
        nCorners == 2
      ? openSegment(corners[0], corners[1])
      : openSquare(corners);
}


Foam::scalar Foam::fsi::openAreaWall::wallDistance
(
    const scalar fluidDistance,
    const scalar solidDistance
) const
{
    return max
    (
        fluidDistance/max(fluidDistance - solidDistance, VSMALL),
        minWallDistance_
    );
}


// ************************************************************************* //
