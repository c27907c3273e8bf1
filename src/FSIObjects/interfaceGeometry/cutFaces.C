// SPDX-License-Identifier: GPL-3.0-or-later

#include "volFields.H"
#include "cutFaces.H"
#include "edgeCuts.H"
#include "fetchAhead.H"
#include "levelSetUpdate.H"
#include "openfoamVersion.H"
#include "surfaceSample.H"
#include "wallTreatment.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cutFaces::setCut
(
    const scalarField& cornerDistance,
    const cartesianBlock& corners,
    const label facei,
    wallOrigin& origin
) const
{
    const FixedList<label, 4> around = grid_.cornersOf(facei);
    FixedList<scalar, 4> distances;
    forAll(around, i)
    {
        distances[i] = cornerDistance[around[i]];
    }
    const edgeCuts cuts
    (
        distances, corners.positions(around), grid_.nDims() == 2 ? 2 : 4
    );
    origin.cut = cuts.n > 0;
    if (origin.cut)
    {
        origin.middle = cuts.middle();
    }
}


void Foam::fsi::cutFaces::addWallFace
(
    const label facei,
    const label own,
    const label nei
)
{
    const bool upwards = grid_.faceAlong(facei);
    wallFace w;
    w.face = facei;
    w.dir = grid_.faceDirection(facei);
    w.lower = upwards ? own : nei;
    w.upper = upwards ? nei : own;
    w.area = 1 - open_.openness()[facei];
    wallFaces_.append(w);
}


void Foam::fsi::cutFaces::addWallLink
(
    const label facei,
    const label celli,
    const label across
)
{
    // The owner is the cell of the lower number
    const bool isOwner = across < 0 || celli < across;
    wallLink link;
    link.cell = celli;
    link.face = facei;
    link.across = across;
    link.dir = grid_.faceDirection(facei);
    link.upwards = grid_.faceAlong(facei) == isOwner;
    wallLinks_.append(link);
}


void Foam::fsi::cutFaces::findWalls()
{
    const polyBoundaryMesh& patches = grid_.mesh().boundaryMesh();
    const labelList& owner = grid_.mesh().faceOwner();
    const labelList& neighbour = grid_.mesh().faceNeighbour();

    const scalarField& openness = open_.openness();
    const boolList& fluidCell = open_.fluidCell();
    const boolList& activeCell = open_.activeCell();
    const boolList& across = open_.fluidAcross();

    wallFaces_.clear();
    innerFaces_.clear();
    wallLinks_.clear();
    for (const label facei : open_.nearFaces())
    {
        const label inBoundary = facei - neighbour.size();
        const label own = owner[facei];
        const label nei = inBoundary < 0 ? neighbour[facei] : -1;
        const bool fluid = fluidCell[own];
        const bool otherFluid = nei < 0 ? across[inBoundary] : fluidCell[nei];
        const bool active = activeCell[own];
        const bool otherActive = nei >= 0 && activeCell[nei];

        if
        (
            openness[facei] < 1
         && (active || otherActive)
         && !open_.films().has(facei)
        )
        {
            if (openness[facei] > 0 && !fluid && !otherFluid)
            {
                innerFaces_.append(wallFaces_.size());
            }
            addWallFace(facei, active ? own : -1, otherActive ? nei : -1);
        }
        if (fluid == otherFluid)
        {
            continue;
        }
        if (nei >= 0)
        {
            addWallLink(facei, fluid ? own : nei, fluid ? nei : own);
        }
        else if (fluid && patches[patches.whichPatch(facei)].coupled())
        {
            addWallLink(facei, own, -1);
        }
    }
}


void Foam::fsi::cutFaces::placeWallFaces
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const vectorField& faceAreas = grid_.mesh().faceAreas();
    const vectorField& faceCentres = grid_.mesh().faceCentres();
    const labelList& owner = grid_.mesh().faceOwner();
    const labelList& haloIndex = grid_.haloIndex();
    const labelList& nearestFace = levelSet.nearestFace();
    const cartesianBlock corners(grid_.corners());
    const Map<wallOrigin>& closed = open_.films().closed();

    DynamicList<label> near;
    wallOrigins_.setSize(wallFaces_.size());
    forAll(wallFaces_, i)
    {
        const wallFace& later = fetchedAhead(wallFaces_, i);
        fetchAhead(faceAreas[later.face]);
        fetchAhead(faceCentres[later.face]);
        fetchAhead(grid_.faceCorners().first()[later.face]);
        fetchAhead(nearestFace[haloIndex[max(later.lower, later.upper)]]);

        wallFace& w = wallFaces_[i];
        wallOrigin& origin = wallOrigins_[i];
        origin.cut = false;
        origin.middle = faceCentres[w.face];
        const auto found = closed.find(w.face);
        if (found != closed.end())
        {
            origin = *found;
        }
        else if (w.area < 1)
        {
            setCut(levelSet.cornerDistance(), corners, w.face, origin);
        }
        w.area *= mag(faceAreas[w.face]);
        const label here = haloIndex[owner[w.face]];
        near.clear();
        for (const label step : {0, grid_.stepAcross(w.face)})
        {
            const label nearest = nearestFace[here + step];
            if (nearest < 0 || isIn(near, nearest))
            {
                continue;
            }
            near.append(nearest);
            // A cut through a corner lies inside it, near to both its faces
            for (label edge = 0; origin.cut && edge < grid_.nDims(); ++edge)
            {
                near.append(surfaces.faceAcross(nearest, edge));
            }
        }
        w.place =
            nearestPlace(surfaces, origin.middle, near, origin.surface);
    }
}


void Foam::fsi::cutFaces::addFilms()
{
    const labelList& owner = grid_.mesh().faceOwner();
    const labelList& neighbour = grid_.mesh().faceNeighbour();
    const vectorField& faceAreas = grid_.mesh().faceAreas();
    for (const filmFace& film : open_.films().faces())
    {
        const label facei = film.face;
        for (label side = 0; side < 2; ++side)
        {
            if (film.closed[side] > 0)
            {
                const bool internal = facei < neighbour.size();
                addWallFace
                (
                    facei, owner[facei], internal ? neighbour[facei] : -1
                );
                wallFace& w = wallFaces_[wallFaces_.size() - 1];
                w.area = film.closed[side]*mag(faceAreas[facei]);
                w.film = true;
                w.place = film.sides[side].place;
                wallOrigins_.append(film.origins[side]);
            }
        }
    }
}


void Foam::fsi::cutFaces::placeWallLinks
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const scalar h = grid_.spacing();
    const vectorField& C = grid_.mesh().C();
    const scalarField& distance = levelSet.cellDistance();
    const labelList& nearestFace = levelSet.nearestFace();
    const labelList& haloIndex = grid_.haloIndex();
    const bool films = open_.films().used(levelSet);
    const surfaceSamples centres(surfaceSamples::centres(levelSet, grid_));
    forAll(wallLinks_, i)
    {
        const label later = fetchedAhead(wallLinks_, i).cell;
        fetchAhead(C[later]);
        fetchAhead(distance[haloIndex[later]]);
        fetchAhead(nearestFace[haloIndex[later]]);

        wallLink& link = wallLinks_[i];
        const label sign = link.upwards ? 1 : -1;
        const label here = haloIndex[link.cell];
        const label there = here + sign*grid_.haloStride(link.dir);
        FixedList<label, 2> faces({nearestFace[here], nearestFace[there]});
        scalar away = distance[here];
        if (films && faces[0] != faces[1])
        {
            surfaceSample{&centres, here}.towards
            (
                surfaces, surfaces.faceObject()[faces[1]], away, faces[0]
            );
        }
        link.wallDistance =
            wall_.wallDistance(away, min(distance[there], 0.0));
        link.conductance = grid_.faceArea()/(link.wallDistance*h);

        point wallPoint(C[link.cell]);
        wallPoint[link.dir] += sign*min(link.wallDistance, 1.0)*h;
        label found;
        link.place = nearestPlace
        (
            surfaces,
            wallPoint,
            faces[0],
            faces[1],
            found
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cutFaces::cutFaces
(
    const openParts& open,
    const wallTreatment& wall
)
:
    grid_(open.grid()),
    open_(open),
    wall_(wall)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cutFaces::update
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    findWalls();
    placeWallFaces(levelSet, surfaces);
    addFilms();
    placeWallLinks(levelSet, surfaces);
}


// ************************************************************************* //
