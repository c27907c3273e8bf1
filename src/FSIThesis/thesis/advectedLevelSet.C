// SPDX-License-Identifier: GPL-3.0-or-later

#include "advectedLevelSet.H"
#include "addToRunTimeSelectionTable.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(advectedLevelSet, 0);
    addToRunTimeSelectionTable(levelSetUpdate, advectedLevelSet, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The dictionary with the default width of this level set's band
static dictionary withBand(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {"type", "bandWidth", "reinitialise", "misfitTolerance", "order"}
    );
    dictionary result(dict);
    result.add("bandWidth", scalar(6), false);
    return result;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::advectedLevelSet::rebuild(const surfaceSet& surfaces)
{
    fields_.start(exact_, surfaces, block_);
    march_.march(block_, fields_);
}


void Foam::fsi::advectedLevelSet::fillHalo(scalarField& phi) const
{
    const label halo = levelSetAdvection::halo;
    const direction nDims = block_.nDims();
    labelVector inner(0, 0, 0);

    for (label i = 0; i < phi.size(); ++i)
    {
        const labelVector ijk(block_.ijk(i));
        bool outside = false;
        inner = ijk;
        for (direction d = 0; d < nDims; ++d)
        {
            const label last = block_.n()[d] - 1 - halo;
            inner[d] = min(max(ijk[d], halo), last);
            if (grid_.period()[d] > 0 && inner[d] != ijk[d])
            {
                // The sample one period away
                const label n = last + 1 - halo;
                inner[d] = ijk[d] < halo ? ijk[d] + n : ijk[d] - n;
            }
            outside = outside || inner[d] != ijk[d];
        }
        if (outside)
        {
            phi[i] = phi[block_.index(inner)];
        }
    }
}


void Foam::fsi::advectedLevelSet::sample(const surfaceSet& surfaces)
{
    // Nearest faces and objects come from the surfaces in any case
    setNearest(surfaces);

    const auto value = [&](const labelVector& global)
    {
        return fields_.phi[block_.index(global - block_.start())];
    };

    const cartesianBlock cells(grid_.cells(1));
    cellDistance_.setSize(cells.size());
    forAll(cellDistance_, i)
    {
        cellDistance_[i] = value(cells.start() + cells.ijk(i));
    }

    // A corner is the mean of the cells around it
    const cartesianBlock corners(grid_.corners());
    const label nAround = 1 << block_.nDims();
    cornerDistance_.setSize(corners.size());
    forAll(cornerDistance_, i)
    {
        const labelVector upper(corners.start() + corners.ijk(i));
        scalar sum = 0;
        for (label k = 0; k < nAround; ++k)
        {
            sum += value
            (
                upper - labelVector(k & 1, (k >> 1) & 1, (k >> 2) & 1)
            );
        }
        cornerDistance_[i] = sum/nAround;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::advectedLevelSet::advectedLevelSet
(
    const cartesianMesh& grid,
    const dictionary& dict
)
:
    levelSetUpdate(grid, withBand(dict)),
    reinitialise_(label(readPositive(dict, "reinitialise", 10))),
    misfitTolerance_(readPositive(dict, "misfitTolerance", 0.25)),
    block_(grid.globalCells(levelSetAdvection::halo)),
    march_
    (
        bandWidth_*grid.spacing(),
        readBetween(dict, "order", 2, 1, 2)
    ),
    advection_(bandWidth_*grid.spacing()),
    exact_(2*grid.spacing()),
    nSteps_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::advectedLevelSet::initialise(const surfaceSet& surfaces)
{
    rebuild(surfaces);
    sample(surfaces);
}


void Foam::fsi::advectedLevelSet::move
(
    const surfaceSet& surfaces,
    const scalar deltaT
)
{
    // The velocity that carried the surfaces here belongs to where they were
    surfaceSet before(surfaces);
    before.points() -= deltaT*surfaces.velocities();
    extension_.start(exact_, before, block_);
    march_.march(block_, extension_);

    advection_.advance
    (
        block_,
        extension_.velocity,
        deltaT,
        fields_.phi,
        [this](scalarField& phi)
        {
            fillHalo(phi);
        }
    );

    ++nSteps_;
    if (nSteps_ % reinitialise_ == 0)
    {
        fields_.velocity = extension_.velocity;
        fields_.object = extension_.object;
        fields_.start(interface_, block_);
        march_.march(block_, fields_);
    }

    sample(surfaces);
    if (misfit(surfaces) > misfitTolerance_)
    {
        rebuild(surfaces);
        sample(surfaces);
        ++nRebuilds_;
    }
}


// ************************************************************************* //
