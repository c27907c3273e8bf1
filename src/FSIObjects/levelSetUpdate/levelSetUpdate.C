// SPDX-License-Identifier: GPL-3.0-or-later

#include "levelSetUpdate.H"
#include "periodicImages.H"
#include "readBetween.H"
#include "blockInterpolation.H"
#include "dictionaryCheck.H"
#include "fetchSamples.H"
#include "selection.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(levelSetUpdate, 0);
    defineRunTimeSelectionTable(levelSetUpdate, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::levelSetUpdate::levelSetUpdate
(
    const cartesianMesh& grid,
    const dictionary& dict
)
:
    grid_(grid),
    bandWidth_(readScalarBetween(dict, "bandWidth", 3, 3, 100)),
    nRebuilds_(0),
    centreSamples_(bandWidth_*grid.spacing()),
    cornerSamples_(bandWidth_*grid.spacing())
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::levelSetUpdate> Foam::fsi::levelSetUpdate::New
(
    const cartesianMesh& grid,
    const dictionary& fsiProperties
)
{
    const dictionary& dict = fsiProperties.subOrEmptyDict("levelSet");
    const word type(readName(dict, "type", "rebuilt"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, fsiProperties, "levelSet", type
    )(grid, dict);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::fsi::levelSetUpdate::centreBubble
(
    const cartesianBlock& centres,
    const cartesianBlock& corners,
    const point& p
) const
{
    // The cell, and the largest distance from its centre in a direction
    const scalar h = centres.spacing();
    labelVector ijk(labelVector::zero);
    point centre(p);
    scalar off = 0;
    for (direction d = 0; d < centres.nDims(); ++d)
    {
        const label i = std::floor((p[d] - centres.origin()[d])/h + 0.5);
        ijk[d] = i - centres.start()[d];
        centre[d] = centres.latticePosition(i, d);
        off = max(off, mag(p[d] - centre[d])/h);
    }
    scalar mean = 0;
    if
    (
        !centres.contains(ijk)
     || !interpolateLinear(corners, cornerDistance_, centre, mean)
    )
    {
        return 0;
    }
    return max(1 - 2*off, 0.0)*(cellDistance_[centres.index(ijk)] - mean);
}


void Foam::fsi::levelSetUpdate::setNearest(const surfaceSet& surfaces)
{
    centreSamples_.update(surfaces, grid_.cells(1));
}


void Foam::fsi::levelSetUpdate::setFromSurfaces(const surfaceSet& surfaces)
{
    if (!periodicImages::anyWalls(surfaces) && !centreSamples_.used())
    {
        // Samples take more memory than the distances
        cellDistance_.setSize(grid_.cells(1).size());
        cornerDistance_.setSize(grid_.corners().size());
        cellDistance_ = bandWidth();
        cornerDistance_ = bandWidth();
        return;
    }
    centreSamples_.swapDistance(cellDistance_);
    cornerSamples_.swapDistance(cornerDistance_);

    setNearest(surfaces);
    cornerSamples_.update(surfaces, grid_.corners());

    centreSamples_.swapDistance(cellDistance_);
    cornerSamples_.swapDistance(cornerDistance_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::levelSetUpdate::misfit
(
    const surfaceSet& surfaces
) const
{
    const cartesianBlock centres(grid_.cells(1));
    const cartesianBlock corners(grid_.corners());
    scalar largest = 0;
    scalar value = 0;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (!surfaces.hasWalls(objecti))
        {
            continue;
        }
        const boundBox box(surfaces.bounds(objecti));
        fetchSamples(centres, box.min(), box.max(), cellDistance_);
        fetchSamples(corners, box.min(), box.max(), cornerDistance_);
        const label end = surfaces.pointStart()[objecti + 1];
        for (label i = surfaces.pointStart()[objecti]; i < end; ++i)
        {
            const point& p = surfaces.points()[i];
            if (interpolateLinear(corners, cornerDistance_, p, value))
            {
                value += centreBubble(centres, corners, p);
                largest = max(largest, mag(value));
            }
        }
    }
    return overRanks(largest, maxOp<scalar>())/grid_.spacing();
}


// ************************************************************************* //
