// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceGeometry.H"
#include "wallTreatment.H"
#include "levelSetUpdate.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::surfacePlace Foam::fsi::interfaceGeometry::nearestPlace
(
    const surfaceSet& surfaces,
    const point& p,
    const label faceA,
    const label faceB
) const
{
    surfacePlace place;
    scalar nearest = GREAT;
    FixedList<scalar, 3> weights;

    for (const label facei : {faceA, faceB})
    {
        if (facei < 0 || facei == place.face)
        {
            continue;
        }
        const scalar distance =
            magSqr(surfaces.nearestOnFace(facei, p, weights) - p);
        if (distance < nearest)
        {
            nearest = distance;
            place.face = facei;
            place.weights = weights;
        }
    }

    if (place.face < 0)
    {
        FatalErrorInFunction
            << "No surface near the wall at " << p
            << exit(FatalError);
    }
    // What is found on an image belongs to its original
    place.nodes = surfaces.faces()[place.face];
    for (label& nodei : place.nodes)
    {
        nodei = surfaces.originalNode(nodei);
    }
    place.object = surfaces.original(surfaces.faceObject()[place.face]);
    place.face = surfaces.originalFace(place.face);
    return place;
}


void Foam::fsi::interfaceGeometry::setWallFaces
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const fvMesh& mesh = grid_.mesh();
    const labelList& owner = mesh.faceOwner();
    const labelList& nearestFace = levelSet.nearestFace();

    wallFaces_.clear();
    grid_.forFaces([&](const label facei)
    {
        const label own = owner[facei];
        const bool internal = facei < mesh.nInternalFaces();
        const label nei = internal ? mesh.faceNeighbour()[facei] : -1;
        const bool ownActive = activeCell_[own];
        const bool neiActive = internal && activeCell_[nei];

        if (openness_[facei] >= 1 || !(ownActive || neiActive))
        {
            return;
        }

        const direction dir = grid_.faceDirection(facei);
        const bool upwards = grid_.faceAlong(facei);
        const label lower = upwards ? own : nei;
        const label upper = upwards ? nei : own;

        wallFace w;
        w.face = facei;
        w.dir = dir;
        w.lower = lower >= 0 && activeCell_[lower] ? lower : -1;
        w.upper = upper >= 0 && activeCell_[upper] ? upper : -1;
        w.area = (1 - openness_[facei])*mag(mesh.faceAreas()[facei]);
        w.place = nearestPlace
        (
            surfaces,
            mesh.faceCentres()[facei],
            nearestFace[haloIndex_[own]],
            nearestFace[acrossFace(facei, dir)]
        );
        wallFaces_.append(w);
    });
}


void Foam::fsi::interfaceGeometry::addWallLink
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces,
    const label facei,
    const label celli,
    const direction dir,
    const label sign
)
{
    const scalar h = grid_.spacing();
    const scalarField& distance = levelSet.cellDistance();
    const labelList& nearestFace = levelSet.nearestFace();
    const label here = haloIndex_[celli];
    const label there = here + sign*grid_.cells(1).stride(dir);

    wallLink link;
    link.cell = celli;
    link.face = facei;
    link.dir = dir;
    link.wallDistance =
        wall_.wallDistance(distance[here], min(distance[there], 0.0));
    link.conductance = grid_.faceArea()/(link.wallDistance*h);

    point wallPoint(grid_.mesh().C()[celli]);
    wallPoint[dir] += sign*min(link.wallDistance, 1.0)*h;
    link.place = nearestPlace
    (
        surfaces,
        wallPoint,
        nearestFace[here],
        nearestFace[there]
    );
    wallLinks_.append(link);
}


void Foam::fsi::interfaceGeometry::setWallLinks
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const fvMesh& mesh = grid_.mesh();
    const auto addLink = [&]
    (
        const label facei,
        const label celli,
        const direction dir,
        const label sign
    )
    {
        addWallLink(levelSet, surfaces, facei, celli, dir, sign);
    };

    wallLinks_.clear();
    grid_.forFaces([&](const label facei)
    {
        const label own = mesh.faceOwner()[facei];
        const bool internal = facei < mesh.nInternalFaces();
        const label nei = internal ? mesh.faceNeighbour()[facei] : -1;
        if (internal && fluidCell_[own] == fluidCell_[nei])
        {
            return;
        }
        const direction dir = grid_.faceDirection(facei);
        const label sign = grid_.faceAlong(facei) ? 1 : -1;

        if (internal && fluidCell_[own])
        {
            addLink(facei, own, dir, sign);
        }
        else if (internal)
        {
            addLink(facei, nei, dir, -sign);
        }
        else if (fluidCell_[own])
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            if
            (
                mesh.boundaryMesh()[patchi].coupled()
             && fluidFace_.boundaryField()[patchi]
                [
                    facei - mesh.boundaryMesh()[patchi].start()
                ] < 0.5
            )
            {
                addLink(facei, own, dir, sign);
            }
        }
    });
}


void Foam::fsi::interfaceGeometry::setInnerFaces()
{
    const fvMesh& mesh = grid_.mesh();

    // Across a coupled patch a link is known to its cell's rank
    boolList linked(mesh.nFaces(), false);
    for (const wallLink& link : wallLinks_)
    {
        linked[link.face] = true;
    }
    syncTools::syncFaceList(mesh, linked, orEqOp<bool>());

    innerFaces_.clear();
    forAll(wallFaces_, i)
    {
        const label facei = wallFaces_[i].face;
        if
        (
            openness_[facei] > 0
         && !fluidCell_[mesh.faceOwner()[facei]]
         && !linked[facei]
        )
        {
            innerFaces_.append(i);
        }
    }
}


// ************************************************************************* //
