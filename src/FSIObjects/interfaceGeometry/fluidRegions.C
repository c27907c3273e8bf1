// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidRegions.H"
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
    const label nPatches = U.boundaryField().size();

    // Inflow into each region through each patch, and all of it; what it would
    // be if all velocities were normal to their faces
    List<scalarField> parts(nPatches, scalarField(regions.nRegions(), Zero));
    scalarField all(regions.nRegions(), Zero);
    scalarField size(all);
    forAll(U.boundaryField(), patchi)
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
            parts[patchi][regioni] -= patch[i] & area;
            size[regioni] += mag(patch[i])*mag(area);
        }
    }
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        sumOverRanks(parts[patchi]);
        all += parts[patchi];
    }
    sumOverRanks(size);

    const scalarField open(openOr(objectMoves, U));
    inflow = 0;
    label found = -1;
    forAll(all, regioni)
    {
        label largest = 0;
        for (label patchi = 1; patchi < nPatches; ++patchi)
        {
            if (mag(parts[patchi][regioni]) > mag(parts[largest][regioni]))
            {
                largest = patchi;
            }
        }
        if (open[regioni] < 0.5 && mag(all[regioni]) > 1e-6*size[regioni])
        {
            inflow = all[regioni];
            found = largest;
        }
    }
    return found;
}


// ************************************************************************* //
