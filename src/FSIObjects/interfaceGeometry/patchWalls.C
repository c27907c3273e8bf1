// SPDX-License-Identifier: GPL-3.0-or-later

#include "patchWalls.H"
#include "domainSides.H"
#include "levelSetUpdate.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::wallFace Foam::fsi::patchWalls::closedPart
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces,
    const label facei,
    const label celli
) const
{
    const fvMesh& mesh = grid_.mesh();
    wallFace w;
    w.face = facei;
    w.dir = grid_.faceDirection(facei);
    const bool upwards = grid_.faceAlong(facei);
    w.lower = upwards ? celli : -1;
    w.upper = upwards ? -1 : celli;
    w.area = (1 - open_.openness()[facei])*mag(mesh.faceAreas()[facei]);

    const label here = grid_.haloIndex()[celli];
    const label there = here + grid_.stepAcross(facei);
    const label nearHere = levelSet.nearestFace(here);
    const label nearThere = levelSet.nearestFace(there);
    if (nearHere >= 0 || nearThere >= 0)
    {
        label found;
        w.place = nearestPlace
        (
            surfaces,
            mesh.faceCentres()[facei],
            nearHere,
            nearThere,
            found
        );
    }
    else
    {
        w.place.object = levelSet.objectAt(here);
        w.place.nodes = -1;
        w.place.weights = 0.0;
    }
    return w;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::patchWalls::patchWalls(const openParts& open)
:
    grid_(open.grid()),
    open_(open)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::patchWalls::update
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const scalarField& openness = open_.openness();
    faces_.clear();
    for (const polyPatch& patch : grid_.mesh().boundaryMesh())
    {
        if (!domainSides::isOpen(patch))
        {
            continue;
        }
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            if (openness[facei] < 1)
            {
                faces_.append
                (
                    closedPart
                    (
                        levelSet, surfaces, facei, patch.faceCells()[i]
                    )
                );
            }
        }
    }
}


// ************************************************************************* //
