// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidRegions.H"
#include "sharedPatches.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fluidRegions::fluidRegions
(
    const interfaceGeometry& geometry,
    const volScalarField& p
)
:
    geometry_(geometry)
{
    const fvMesh& mesh = geometry.grid().mesh();
    boolList blocked(mesh.nFaces(), false);
    forAll(blocked, facei)
    {
        blocked[facei] = geometry.openness()[facei] <= 0;
    }
    regions_.reset(new regionSplit(mesh, blocked));
    const regionSplit& regions = *regions_;

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
    wallArea_.setSize(regions.nRegions(), Zero);
    forAll(cellWallArea_, celli)
    {
        if (geometry.activeCell()[celli])
        {
            wallArea_[regions[celli]] += cellWallArea_[celli];
        }
    }
    open_.setSize(regions.nRegions(), Zero);
    for (const fvPatchScalarField& pp : p.boundaryField())
    {
        if (pp.fixesValue())
        {
            for (const label celli : pp.patch().faceCells())
            {
                open_[regions[celli]] = 1;
            }
        }
    }
    sumOverRanks(wallArea_);
    sumOverRanks(open_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fluidRegions::removeNetSource(scalarField& source) const
{
    const regionSplit& regions = *regions_;
    const boolList& active = geometry_.activeCell();

    scalarField net(regions.nRegions(), Zero);
    forAll(source, celli)
    {
        if (active[celli])
        {
            net[regions[celli]] += source[celli];
        }
    }
    sumOverRanks(net);

    forAll(source, celli)
    {
        const label regioni = regions[celli];
        if (active[celli] && open_[regioni] < 0.5 && wallArea_[regioni] > 0)
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
    const regionSplit& regions = *regions_;
    scalarField open(open_);
    for (const wallFace& w : geometry_.wallFaces())
    {
        const label celli = w.lower >= 0 ? w.lower : w.upper;
        if (celli >= 0 && objectMoves[w.place.object])
        {
            open[regions[celli]] += 1;
        }
    }
    for (const fvPatchVectorField& patch : U.boundaryField())
    {
        if (!patch.coupled() && !patch.fixesValue())
        {
            for (const label celli : patch.patch().faceCells())
            {
                open[regions[celli]] += 1;
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
    const regionSplit& regions = *regions_;
    const label nRegions = regions.nRegions();
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
            const label regioni = regions[patch.patch().faceCells()[i]];
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
