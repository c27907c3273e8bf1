// SPDX-License-Identifier: GPL-3.0-or-later

#include "voxelWall.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(voxelWall, 0);
    addToRunTimeSelectionTable(wallTreatment, voxelWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::voxelWall::voxelWall(const dictionary&)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::voxelWall::openness
(
    const FixedList<scalar, 4>&,
    const label,
    const scalar ownDistance,
    const scalar neighbourDistance
) const
{
    return ownDistance > 0 && neighbourDistance > 0 ? 1 : 0;
}


Foam::scalar Foam::fsi::voxelWall::wallDistance
(
    const scalar,
    const scalar
) const
{
    return 0.5;
}


// ************************************************************************* //
