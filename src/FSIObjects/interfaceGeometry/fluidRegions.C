// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidRegions.H"
#include "sharedPatches.H"
#include "globalMeshData.H"
#include "regionSplit.H"
#include "sumOverRanks.H"

#include <map>
#include <set>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fluidRegions::number()
{
    const fvMesh& mesh = geometry_.grid().mesh();
    boolList blocked(mesh.nFaces(), false);
    bool any = false;
    forAll(blocked, facei)
    {
        blocked[facei] = geometry_.openness()[facei] <= 0;
        any = any || blocked[facei];
    }
    const labelVector& n = geometry_.grid().globalN();
    if
    (
        mesh.globalData().nTotalCells() == n.x()*n.y()*n.z()
     && !overRanks(any, orOp<bool>())
    )
    {
        // A whole box; regionSplit would need a list of each cell's faces
        nRegions_ = 1;
        region_ = 0;
        return;
    }
    const regionSplit regions(mesh, blocked);
    std::set<label> here;
    forAll(regions, celli)
    {
        if (geometry_.activeCell()[celli])
        {
            here.insert(regions[celli]);
        }
    }
    labelList mine(here.size());
    std::copy(here.begin(), here.end(), mine.begin());
    std::map<label, label> places;
    for (const labelList& ofRank : gatherOverRanks(mine))
    {
        for (const label regioni : ofRank)
        {
            places[regioni] = 0;
        }
    }
    nRegions_ = 0;
    for (auto& place : places)
    {
        place.second = nRegions_++;
    }
    forAll(regions, celli)
    {
        if (geometry_.activeCell()[celli])
        {
            region_[celli] = places[regions[celli]];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fluidRegions::fluidRegions
(
    const interfaceGeometry& geometry,
    const volScalarField& p
)
:
    geometry_(geometry),
    region_(geometry.grid().mesh().nCells(), -1),
    nRegions_(0)
{
    number();
    const fvMesh& mesh = geometry.grid().mesh();
    cellWallArea_.setSize(mesh.nCells(), Zero);
    for (const wallFace& w : geometry.wallFaces())
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0)
            {
                cellWallArea_[celli] += w.area;
            }
        }
    }
    wallArea_.setSize(nRegions_, Zero);
    forAll(cellWallArea_, celli)
    {
        if (region_[celli] >= 0)
        {
            wallArea_[region_[celli]] += cellWallArea_[celli];
        }
    }
    open_.setSize(nRegions_, Zero);
    for (const fvPatchScalarField& pp : p.boundaryField())
    {
        if (pp.fixesValue())
        {
            for (const label celli : pp.patch().faceCells())
            {
                if (region_[celli] >= 0)
                {
                    open_[region_[celli]] = 1;
                }
            }
        }
    }
    sumOverRanks(wallArea_);
    sumOverRanks(open_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fluidRegions::removeNetSource(scalarField& source) const
{
    scalarField net(nRegions_, Zero);
    forAll(source, celli)
    {
        if (region_[celli] >= 0)
        {
            net[region_[celli]] += source[celli];
        }
    }
    sumOverRanks(net);

    forAll(source, celli)
    {
        const label regioni = region_[celli];
        if (regioni >= 0 && open_[regioni] < 0.5 && wallArea_[regioni] > 0)
        {
            source[celli] -=
                net[regioni]*cellWallArea_[celli]/wallArea_[regioni];
        }
    }
}


Foam::scalarField Foam::fsi::fluidRegions::openOr
(
    const boolList& objectMoves,
    const volVectorField& U
) const
{
    scalarField open(open_);
    for (const wallFace& w : geometry_.wallFaces())
    {
        const label celli = w.lower >= 0 ? w.lower : w.upper;
        if
        (
            celli >= 0 && region_[celli] >= 0
         && objectMoves[w.place.object]
        )
        {
            open[region_[celli]] += 1;
        }
    }
    for (const fvPatchVectorField& patch : U.boundaryField())
    {
        if (!patch.coupled() && !patch.fixesValue())
        {
            for (const label celli : patch.patch().faceCells())
            {
                if (region_[celli] >= 0)
                {
                    open[region_[celli]] += 1;
                }
            }
        }
    }
    sumOverRanks(open);
    return open;
}


Foam::label Foam::fsi::fluidRegions::closedInlet
(
    const volVectorField& U,
    const boolList& objectMoves,
    scalar& inflow
) const
{
    const label nRegions = nRegions_;
    const label nPatches = nSharedPatches(U.mesh().boundaryMesh());

    // Inflow into each region through each patch, patch by patch; behind it
    // what all would be if the velocities were normal to their faces
    scalarField parts((nPatches + 1)*nRegions, Zero);
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const fvPatchVectorField& patch = U.boundaryField()[patchi];
        if (patch.coupled() || !patch.size())
        {
            continue;
        }
        const vectorField& areas = patch.patch().Sf();
        forAll(patch, i)
        {
            const label regioni = region_[patch.patch().faceCells()[i]];
            if (regioni < 0)
            {
                continue;
            }
            const vector area
            (
                geometry_.openness()[patch.patch().start() + i]*areas[i]
            );
            parts[nRegions*patchi + regioni] -= patch[i] & area;
            parts[nRegions*nPatches + regioni] += mag(patch[i])*mag(area);
        }
    }
    sumOverRanks(parts);

    const scalarField open(openOr(objectMoves, U));
    inflow = 0;
    label found = -1;
    for (label regioni = 0; regioni < nRegions; ++regioni)
    {
        const auto part = [&](const label patchi)
        {
            return parts[nRegions*patchi + regioni];
        };
        label largest = 0;
        scalar all = 0;
        for (label patchi = 0; patchi < nPatches; ++patchi)
        {
            all += part(patchi);
            if (mag(part(patchi)) > mag(part(largest)))
            {
                largest = patchi;
            }
        }
        if (open[regioni] < 0.5 && mag(all) > 1e-6*part(nPatches))
        {
            inflow = all;
            found = largest;
        }
    }
    return found;
}


// ************************************************************************* //
