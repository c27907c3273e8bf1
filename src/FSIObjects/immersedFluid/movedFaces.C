// SPDX-License-Identifier: GPL-3.0-or-later

#include "movedFaces.H"
#include "atFace.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

char Foam::fsi::movedFaces::kindOf(const label facei) const
{
    const scalar open = geometry_.openness()[facei];
    if (open <= 0)
    {
        return closed;
    }
    if (geometry_.films().has(facei))
    {
        return film;
    }
    const fvMesh& mesh = geometry_.grid().mesh();
    const boolList& fluid = geometry_.fluidCell();
    const label nInternal = mesh.nInternalFaces();
    const bool own = fluid[mesh.faceOwner()[facei]];
    const bool other =
        facei < nInternal
      ? fluid[mesh.faceNeighbour()[facei]]
      : geometry_.fluidAcross()[facei - nInternal];
    return (own ? 2 : 0) + (other ? 2 : 0) + (open < 0.5 ? 0 : 1);
}


char Foam::fsi::movedFaces::kindBefore(const label facei) const
{
    if (!wasFar(facei))
    {
        return kind_[facei];
    }
    return geometry_.lastOpenness()[facei] > 0 ? between : closed;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::movedFaces::movedFaces
(
    const interfaceGeometry& geometry,
    const faceVelocities& faces
)
:
    geometry_(geometry),
    faces_(faces)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::movedFaces::begin
(
    const volVectorField& U,
    const vectorField& walls
)
{
    near_ = geometry_.nearFaces();
    kind_.setSize(near_.size() ? U.mesh().nFaces() : 0);
    kind_ = far;
    for (const label facei : near_)
    {
        kind_[facei] = kindOf(facei);
    }
    before_ = faces_.nearVelocity(U, walls, near_);
}


void Foam::fsi::movedFaces::end
(
    const volVectorField& U,
    const vectorField& walls,
    const scalar rate,
    const scalar perSpeed,
    surfaceScalarField& history
)
{
    const bool began = before_.valid();
    if (!began)
    {
        near_.clear();
    }
    for (const label facei : geometry_.nearFaces())
    {
        if (!began || wasFar(facei))
        {
            near_.append(facei);
        }
    }
    after_ = faces_.nearVelocity(U, walls, near_);
    const auto jump = [&](const scalar before, const scalar after)
    {
        return (before - after)/(1 + rate + mag(after)*perSpeed);
    };
    const fvMesh& mesh = U.mesh();
    const label nInternal = mesh.nInternalFaces();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    for (const label facei : SubList<label>(near_, began ? near_.size() : 0))
    {
        const char before = kindBefore(facei);
        const char now = kindOf(facei);
        if
        (
            now != before && now != closed && before != closed
         && (
                facei < nInternal
             || patches[patches.whichPatch(facei)].coupled()
            )
        )
        {
            const scalar velocity =
                wasFar(facei) && facei < nInternal
              ? faces_.mean(U, mesh.owner(), mesh.neighbour(), facei)
              : atFace(before_(), facei);
            atFace(history, facei) += jump(velocity, atFace(after_(), facei));
        }
    }
    // Walls alone do not tell the velocity in films
    for (const filmFace& film : geometry_.films().faces())
    {
        atFace(after_.ref(), film.face) += atFace(history, film.face);
    }
    before_.clear();
}


void Foam::fsi::movedFaces::setFlux(surfaceScalarField& flux)
{
    const scalarField& open = geometry_.openness();
    const scalarField& last = geometry_.lastOpenness();
    const scalar area = geometry_.grid().faceArea();
    const surfaceScalarField& velocity = after_();
    for (const label facei : near_)
    {
        if (facei < flux.size() && (open[facei] < 1 || last[facei] < 1))
        {
            flux[facei] = open[facei]*area*velocity[facei];
        }
    }
    forAll(flux.boundaryField(), patchi)
    {
        fvsPatchScalarField& pf = flux.boundaryFieldRef()[patchi];
        const scalarField& pv = velocity.boundaryField()[patchi];
        const label start = pf.patch().start();
        for (label i = 0; i < pf.size() && pf.coupled(); ++i)
        {
            if (open[start + i] < 1 || last[start + i] < 1)
            {
                pf[i] = open[start + i]*area*pv[i];
            }
        }
    }
    after_.clear();
}


// ************************************************************************* //
