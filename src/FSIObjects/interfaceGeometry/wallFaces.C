// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceGeometry.H"
#include "wallTreatment.H"
#include "levelSetUpdate.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::interfaceGeometry::setCut
(
    const scalarField& cornerDistance,
    const cartesianBlock& corners,
    const label facei,
    wallOrigin& origin
) const
{
    const FixedList<label, 4>& around = grid_.faceCorners(facei);
    const label nCorners = grid_.nDims() == 2 ? 2 : 4;
    const bool isOpen = openness_[facei] > 0 && openness_[facei] < 1;
    label nCut = 0;
    point sum(Zero);
    for (label i = 0; i < nCorners && isOpen; ++i)
    {
        // In 2D the second edge is the first one
        const label a = around[i];
        const label b = around[(i + 1) % nCorners];
        const scalar distanceA = cornerDistance[a];
        const scalar distanceB = cornerDistance[b];
        if ((distanceA > 0) != (distanceB > 0))
        {
            const scalar part = distanceA/(distanceA - distanceB);
            sum += (1 - part)*corners.position(a) + part*corners.position(b);
            ++nCut;
        }
    }
    origin.cut = nCut > 0;
    origin.middle =
        origin.cut ? sum/nCut : point(grid_.mesh().faceCentres()[facei]);
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
    const cartesianBlock corners(grid_.corners());

    wallFaces_.clear();
    wallOrigins_.clear();
    for (const label facei : nearFaces_)
    {
        const label own = owner[facei];
        const bool internal = facei < mesh.nInternalFaces();
        const label nei = internal ? mesh.faceNeighbour()[facei] : -1;
        const bool ownActive = activeCell_[own];
        const bool neiActive = internal && activeCell_[nei];

        if (openness_[facei] >= 1 || !(ownActive || neiActive))
        {
            continue;
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

        wallOrigin origin;
        setCut(levelSet.cornerDistance(), corners, facei, origin);
        w.place = nearestPlace
        (
            surfaces,
            origin.middle,
            nearestFace[haloIndex_[own]],
            nearestFace[acrossFace(facei, dir)],
            origin.surface
        );
        wallFaces_.append(w);
        wallOrigins_.append(origin);
    }
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
    label found;
    link.place = nearestPlace
    (
        surfaces,
        wallPoint,
        nearestFace[here],
        nearestFace[there],
        found
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
    for (const label facei : nearFaces_)
    {
        const label own = mesh.faceOwner()[facei];
        const bool internal = facei < mesh.nInternalFaces();
        const label nei = internal ? mesh.faceNeighbour()[facei] : -1;
        if (internal && fluidCell_[own] == fluidCell_[nei])
        {
            continue;
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
    }
}


void Foam::fsi::interfaceGeometry::setInnerFaces(const boolList& across)
{
    const fvMesh& mesh = grid_.mesh();
    innerFaces_.clear();
    forAll(wallFaces_, i)
    {
        const label facei = wallFaces_[i].face;
        const label inBoundary = facei - mesh.nInternalFaces();
        const bool otherFluid =
            inBoundary < 0
          ? fluidCell_[mesh.faceNeighbour()[facei]]
          : across[inBoundary];
        if
        (
            openness_[facei] > 0
         && !fluidCell_[mesh.faceOwner()[facei]]
         && !otherFluid
        )
        {
            innerFaces_.append(i);
        }
    }
}


// ************************************************************************* //
