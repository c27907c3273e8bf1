// SPDX-License-Identifier: GPL-3.0-or-later

#include "domainSides.H"
#include "interfaceGeometry.H"
#include "levelSetUpdate.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::interfaceGeometry::setOutsideWalls
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const fvMesh& mesh = grid_.mesh();
    outsideWalls_.clear();
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!domainSides::isOpen(patch))
        {
            continue;
        }
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const label celli = patch.faceCells()[i];
            if (openness_[facei] >= 1)
            {
                continue;
            }
            wallFace w;
            w.face = facei;
            w.dir = grid_.faceDirection(facei);
            const bool upwards = grid_.faceAlong(facei);
            w.lower = upwards ? celli : -1;
            w.upper = upwards ? -1 : celli;
            w.area = (1 - openness_[facei])*mag(mesh.faceAreas()[facei]);

            const label here = grid_.haloIndex()[celli];
            const label there = here + grid_.stepAcross(facei);
            const label nearHere = levelSet.nearestFace()[here];
            const label nearThere = levelSet.nearestFace()[there];
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
                w.place.object = levelSet.object()[here];
                w.place.nodes = -1;
                w.place.weights = 0.0;
            }
            outsideWalls_.append(w);
        }
    }
}


// ************************************************************************* //
