// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidRegions.H"
#include "regionSplit.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::removeNetSource
(
    const interfaceGeometry& geometry,
    const volScalarField& p,
    scalarField& source
)
{
    const fvMesh& mesh = geometry.grid().mesh();
    const boolList& active = geometry.activeCell();
    boolList blocked(mesh.nFaces(), false);
    forAll(blocked, facei)
    {
        blocked[facei] = geometry.openness()[facei] <= 0;
    }
    const regionSplit regions(mesh, blocked);

    // Wall area in each cell: the net source goes where walls move
    scalarField wallArea(mesh.nCells(), Zero);
    for (const wallFace& w : geometry.wallFaces())
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0)
            {
                wallArea[celli] += w.area;
            }
        }
    }

    // Regions with a patch of fixed pressure need no such care
    scalarField net(regions.nRegions(), Zero);
    scalarField area(regions.nRegions(), Zero);
    scalarField open(regions.nRegions(), Zero);
    forAll(source, celli)
    {
        if (active[celli])
        {
            net[regions[celli]] += source[celli];
            area[regions[celli]] += wallArea[celli];
        }
    }
    for (const fvPatchScalarField& pp : p.boundaryField())
    {
        if (pp.fixesValue())
        {
            for (const label celli : pp.patch().faceCells())
            {
                open[regions[celli]] = 1;
            }
        }
    }
    sumOverRanks(net);
    sumOverRanks(area);
    sumOverRanks(open);

    forAll(source, celli)
    {
        const label regioni = regions[celli];
        if (active[celli] && open[regioni] < 0.5 && area[regioni] > 0)
        {
            source[celli] -= net[regioni]*wallArea[celli]/area[regioni];
        }
    }
}


// ************************************************************************* //
