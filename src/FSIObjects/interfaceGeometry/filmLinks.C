// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmLinks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::filmLinks::addLink
(
    const surfaceSamples& all,
    const surfaceSet& surfaces,
    const label facei,
    const label here,
    const label there
)
{
    const cartesianMesh& grid = open_.grid();
    const FixedList<surfaceSample, 2> samples
    ({
        surfaceSample{&all, here}, surfaceSample{&all, there}
    });

    // Where the line from each centre to the other leaves its object
    FixedList<scalar, 2> leaves;
    FixedList<FixedList<label, 2>, 2> faces;
    for (label side = 0; side < 2; ++side)
    {
        const scalar inside = -samples[side].distance();
        faces[side][0] = samples[side].nearestFace();
        scalar outside;
        if
        (
            !samples[1 - side].from
            (
                surfaces,
                surfaces.faceObject()[faces[side][0]],
                outside,
                faces[side][1]
            )
        )
        {
            return;
        }
        leaves[side] = inside/max(inside + outside, VSMALL);
    }

    const FixedList<point, 2> centres
    ({
        all.block.position(here), all.block.position(there)
    });
    filmLink link;
    for (label side = 0; side < 2; ++side)
    {
        label found;
        link.sides[side].place = nearestPlace
        (
            surfaces,
            (1 - leaves[side])*centres[side] + leaves[side]*centres[1 - side],
            faces[side][0],
            faces[side][1],
            found
        );
    }
    const scalar width =
        max(1 - leaves[0] - leaves[1], filmFaces::thinnest);
    link.conductance = grid.faceArea()/(width*grid.spacing());
    links_.append(link);
}


void Foam::fsi::filmLinks::addWallLink
(
    const surfaceSamples& all,
    const surfaceSet& surfaces,
    const label facei,
    const label here
)
{
    const cartesianMesh& grid = open_.grid();
    const surfaceSample sample{&all, here};
    const point centre(all.block.position(here));
    const point wall(grid.mesh().faceCentres()[facei]);
    const label nearest = sample.nearestFace();
    FixedList<scalar, 3> weights;
    const scalar outside =
        mag(wall - surfaces.nearestOnFace(nearest, wall, weights));
    const scalar inside = -sample.distance();
    const scalar leaves = inside/max(inside + outside, VSMALL);

    filmLink link;
    label found;
    link.sides[0].place = nearestPlace
    (
        surfaces,
        (1 - leaves)*centre + leaves*wall,
        nearest,
        -1,
        found
    );
    link.sides[1].wallFace = facei;
    const scalar width = max(0.5*(1 - leaves), filmFaces::thinnest);
    link.conductance = grid.faceArea()/(width*grid.spacing());
    links_.append(link);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmLinks::filmLinks(const openParts& open)
:
    open_(open)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmLinks::update
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    links_.clear();
    if (!open_.films().used(levelSet))
    {
        return;
    }
    const cartesianMesh& grid = open_.grid();
    const polyBoundaryMesh& patches = grid.mesh().boundaryMesh();
    const labelList& owner = grid.mesh().faceOwner();
    const labelList& haloIndex = grid.haloIndex();
    const scalarField& distance = levelSet.cellDistance();
    const labelList& nearest = levelSet.nearestFace();
    const surfaceSamples centres(surfaceSamples::centres(levelSet, grid));
    for (const label facei : open_.nearFaces())
    {
        const label here = haloIndex[owner[facei]];
        const label there = here + grid.stepAcross(facei);
        if (distance[here] > 0 || nearest[here] < 0)
        {
            continue;
        }
        if (open_.films().isWall(facei))
        {
            if (open_.openness()[facei] > 0)
            {
                addWallLink(centres, surfaces, facei, here);
            }
            continue;
        }
        if
        (
            distance[there] > 0
         || nearest[there] < 0
         || surfaces.faceObject()[nearest[here]]
         == surfaces.faceObject()[nearest[there]]
        )
        {
            continue;
        }
        // A coupled patch has the face on both sides, and the link on one
        const label patchi =
            facei < grid.mesh().nInternalFaces()
          ? -1
          : patches.whichPatch(facei);
        if
        (
            patchi < 0
         || (patches[patchi].coupled() && grid.faceAlong(facei))
        )
        {
            addLink(centres, surfaces, facei, here, there);
        }
    }
}


// ************************************************************************* //
