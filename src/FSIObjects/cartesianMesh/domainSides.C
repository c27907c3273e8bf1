// SPDX-License-Identifier: GPL-3.0-or-later

#include "domainSides.H"
#include "emptyPolyPatch.H"
#include "openfoamVersion.H"
#include "sideFaces.H"
#include "sumOverRanks.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::domainSides::kind
Foam::fsi::domainSides::kindOf(const polyPatch& patch)
{
    if
    (
        isA<wallPolyPatch>(patch)
     || isA<symmetryPlanePolyPatch>(patch)
     || isA<symmetryPolyPatch>(patch)
    )
    {
        return WALL;
    }
    if (isA<emptyPolyPatch>(patch))
    {
        return EMPTY;
    }
    // Faces between ranks lie on a side only where the domain repeats
    return patch.coupled() ? CYCLIC : OPEN;
}


void Foam::fsi::domainSides::addPatch(const polyPatch& patch)
{
    const label kind = kindOf(patch);
    FixedList<bool, 6> touches(false);
    forAll(patch, facei)
    {
        if (kind == WALL || kind == OPEN)
        {
            sideFaces::check(bounds_, patch, facei);
        }
        forAll(touches, sidei)
        {
            touches[sidei] =
                touches[sidei]
             || sideFaces::isOn(sidei, bounds_, patch, facei);
        }
    }
    forAll(touches, sidei)
    {
        if (touches[sidei])
        {
            kinds_[sidei] = max(kinds_[sidei], kind);
            rough_[sidei] = rough_[sidei] || isA<wallPolyPatch>(patch);
            if (kind == OPEN)
            {
                patches_[sidei].append(patch.name());
            }
        }
    }
}


void Foam::fsi::domainSides::setWalls(const polyMesh& mesh)
{
    DynamicList<contactWall> walls;
    for (label sidei = 0; sidei < 6; ++sidei)
    {
        if (kinds_[sidei] != WALL)
        {
            continue;
        }
        walls.append
        (
            contactWall
            (
                sidei % 2 ? bounds_.max() : bounds_.min(),
                -outward(sidei),
                !rough_[sidei]
            )
        );
        if (patches_[sidei].size())
        {
            sideFaces::leaveOpenings
            (
                mesh, sidei, period(), patches_[sidei], walls.last()
            );
        }
    }
    walls_ = walls;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::domainSides::domainSides(const fvMesh& mesh)
:
    bounds_(mesh.bounds()),
    kinds_(label(EMPTY)),
    rough_(label(0))
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        addPatch(patch);
    }
    for (const FixedList<label, 6>& kinds : gatherOverRanks(kinds_))
    {
        forAll(kinds, sidei)
        {
            kinds_[sidei] = max(kinds_[sidei], kinds[sidei]);
        }
    }
    for (const FixedList<label, 6>& rough : gatherOverRanks(rough_))
    {
        forAll(rough, sidei)
        {
            rough_[sidei] = rough_[sidei] || rough[sidei];
        }
    }
    for (const FixedList<wordList, 6>& patches : gatherOverRanks(patches_))
    {
        forAll(patches, sidei)
        {
            for (const word& name : patches[sidei])
            {
                if (!isIn(patches_[sidei], name))
                {
                    patches_[sidei].append(name);
                }
            }
        }
    }
    for (wordList& names : patches_)
    {
        Foam::sort(names);
    }
    setWalls(mesh);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::vector Foam::fsi::domainSides::outward(const label sidei)
{
    vector n(Zero);
    n[sidei/2] = sidei % 2 ? 1 : -1;
    return n;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::domainSides::period() const
{
    vector length(Zero);
    for (direction d = 0; d < 3; ++d)
    {
        if (kinds_[2*d] == CYCLIC && kinds_[2*d + 1] == CYCLIC)
        {
            length[d] = bounds_.span()[d];
        }
    }
    return length;
}


Foam::label Foam::fsi::domainSides::findPatch(const word& patch) const
{
    label found = -1;
    for (label sidei = 0; sidei < 6; ++sidei)
    {
        if (isIn(patches_[sidei], patch))
        {
            if (found >= 0)
            {
                return -1;
            }
            found = sidei;
        }
    }
    return found;
}


Foam::wordList Foam::fsi::domainSides::openPatches() const
{
    wordList names;
    for (const wordList& onSide : patches_)
    {
        names.append(onSide);
    }
    return names;
}


Foam::scalar Foam::fsi::domainSides::beyond
(
    const label sidei,
    const boundBox& box
) const
{
    const direction d = sidei/2;
    return
        sidei % 2
      ? box.min()[d] - bounds_.max()[d]
      : bounds_.min()[d] - box.max()[d];
}


bool Foam::fsi::domainSides::behindWall(const UList<point>& points) const
{
    vector away;
    for (const contactWall& wall : walls_)
    {
        for (const point& p : points)
        {
            if (wall.gap(p, away) < 0)
            {
                return true;
            }
        }
    }
    return false;
}


void Foam::fsi::domainSides::setVelocities
(
    const volVectorField& U,
    UList<contactWall>& walls
) const
{
    // Of each side the velocity times the area, and the area
    vectorField sums(6, Zero);
    scalarField areas(6, Zero);
    for (const fvPatchVectorField& patch : U.boundaryField())
    {
        const vectorField& S = patch.patch().Sf();
        forAll(patch, i)
        {
            for (label sidei = 0; sidei < 6; ++sidei)
            {
                const scalar area = S[i] & outward(sidei);
                if (isA<wallPolyPatch>(patch.patch().patch()) && area > 0)
                {
                    sums[sidei] += area*patch[i];
                    areas[sidei] += area;
                }
            }
        }
    }
    sumOverRanks(sums, areas);
    label walli = 0;
    for (label sidei = 0; sidei < 6; ++sidei)
    {
        if (kinds_[sidei] == WALL)
        {
            const vector n(outward(sidei));
            const vector v(sums[sidei]/max(areas[sidei], VSMALL));
            walls[walli++].setVelocity(v - (v & n)*n);
        }
    }
}


Foam::fsi::periodicImages Foam::fsi::domainSides::images() const
{
    return periodicImages(bounds_, period());
}


// ************************************************************************* //
