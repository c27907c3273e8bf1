// SPDX-License-Identifier: GPL-3.0-or-later

#include "levelSetUpdate.H"
#include "dictionaryCheck.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(levelSetUpdate, 0);
    defineRunTimeSelectionTable(levelSetUpdate, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Multilinear interpolation on a block; false if p is not inside it
static bool interpolate
(
    const cartesianBlock& block,
    const scalarField& values,
    const point& p,
    scalar& value
)
{
    const point first(block.position(0));
    labelVector lower(0, 0, 0);
    vector part(Zero);
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        const scalar s = (p[dir] - first[dir])/block.spacing();
        if (s < 0 || s >= block.n()[dir] - 1)
        {
            return false;
        }
        lower[dir] = label(s);
        part[dir] = s - lower[dir];
    }

    value = 0;
    const label nCorners = 1 << block.nDims();
    for (label corner = 0; corner < nCorners; ++corner)
    {
        labelVector ijk(lower);
        scalar weight = 1;
        for (direction dir = 0; dir < block.nDims(); ++dir)
        {
            const bool upper = corner & (1 << dir);
            ijk[dir] += upper ? 1 : 0;
            weight *= upper ? part[dir] : 1 - part[dir];
        }
        value += weight*values[block.index(ijk)];
    }
    return true;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::levelSetUpdate::levelSetUpdate
(
    const cartesianMesh& grid,
    const dictionary& dict
)
:
    grid_(grid),
    bandWidth_(readPositive(dict, "bandWidth", 4)),
    nRebuilds_(0),
    centreSamples_(bandWidth_*grid.spacing()),
    cornerSamples_(bandWidth_*grid.spacing())
{
    if (bandWidth_ < 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'bandWidth' in dictionary " << dict.name() << " is "
            << bandWidth_ << " cells but must be at least 3"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::levelSetUpdate> Foam::fsi::levelSetUpdate::New
(
    const cartesianMesh& grid,
    const dictionary& fsiProperties
)
{
    const dictionary& dict = fsiProperties.subOrEmptyDict("levelSet");
    const word type(dict.lookupOrDefault<word>("type", "rebuilt"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, fsiProperties, "levelSet", type
    )(grid, dict);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::fsi::levelSetUpdate::setNearest(const surfaceSet& surfaces)
{
    centreSamples_.update(surfaces, grid_.cells(1));
    nearestFace_ = centreSamples_.nearestFace();
    object_ = centreSamples_.object();
    for (label& objecti : object_)
    {
        objecti = objecti < 0 ? -1 : surfaces.original(objecti);
    }
}


void Foam::fsi::levelSetUpdate::setFromSurfaces(const surfaceSet& surfaces)
{
    setNearest(surfaces);
    cornerSamples_.update(surfaces, grid_.corners());

    cellDistance_ = centreSamples_.distance();
    cornerDistance_ = cornerSamples_.distance();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::levelSetUpdate::misfit
(
    const surfaceSet& surfaces
) const
{
    const cartesianBlock block(grid_.corners());
    scalar largest = 0;
    scalar value = 0;
    for (const point& p : surfaces.points())
    {
        if (interpolate(block, cornerDistance_, p, value))
        {
            largest = max(largest, mag(value));
        }
    }
    return returnReduce(largest, maxOp<scalar>())/grid_.spacing();
}


// ************************************************************************* //
