// SPDX-License-Identifier: GPL-3.0-or-later

#include "scalarSurfaces.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "fsiObjects.H"
#include "interfaceGeometry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::scalarSurfaces::surface Foam::fsi::scalarSurfaces::read
(
    const dictionary& dict
)
{
    const word type
    (
        readChoice
        (
            dict, "type", "blocked",
            {"blocked", "fixedValue", "flux", "permeable"}
        )
    );
    surface s;
    if (type == "fixedValue")
    {
        checkKeys(dict, {"type", "value"});
        s.type = fixedValue;
        s.value = readEntry<scalar>(dict, "value");
    }
    else if (type == "flux")
    {
        checkKeys(dict, {"type", "flux"});
        s.type = flux;
        s.value = readEntry<scalar>(dict, "flux");
    }
    else if (type == "permeable")
    {
        checkKeys(dict, {"type", "partition", "diffusivity", "source"});
        s.type = permeable;
        s.value = readEntryOr<scalar>(dict, "source", 0);
        s.partition = readPositive(dict, "partition", 1);
        s.diffusivity = s.partition*readPositive(dict, "diffusivity");
    }
    else
    {
        checkKeys(dict, {"type"});
    }
    return s;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::scalarSurfaces::scalarSurfaces
(
    const fsiObjects& objects,
    const interfaceGeometry& geometry,
    const dictionary& dict
)
:
    objects_(objects),
    geometry_(geometry),
    surfaces_(objects.bodies().groups().size()),
    group_(objects.grid().mesh().nCells(), -1),
    fixed_(group_.size(), false),
    beside_(group_.size(), false)
{
    wordList names;
    forAll(surfaces_, groupi)
    {
        const bodyGroup& group = objects.bodies().groups()[groupi];
        if (group.hasWalls())
        {
            const word& name = group.shape().name();
            names.append(name);
            checkSubDicts(dict, {name});
            surfaces_[groupi] = read(dict.subOrEmptyDict(name));
        }
    }
    checkKeys(dict, names);
    update();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::scalarSurfaces::update()
{
    const population& bodies = objects_.bodies();
    const levelSetUpdate& levelSet = objects_.levelSet();
    const scalarField& distance = levelSet.cellDistance();
    const labelList& haloIndex = objects_.grid().haloIndex();
    const boolList& fluid = geometry_.fluidCell();
    const scalar near = objects_.grid().spacing();
    forAll(group_, celli)
    {
        const label here = haloIndex[celli];
        const label objecti = levelSet.objectAt(here);
        group_[celli] = objecti >= 0 ? bodies.objectGroup(objecti) : -1;
        const bool ofValue =
            group_[celli] >= 0
         && surfaces_[group_[celli]].type == fixedValue;
        fixed_[celli] = ofValue && !fluid[celli];
        beside_[celli] =
            ofValue && fluid[celli] && distance[here] < near;
    }
}


bool Foam::fsi::scalarSurfaces::anyPermeable() const
{
    for (const surface& s : surfaces_)
    {
        if (s.type == permeable)
        {
            return true;
        }
    }
    return false;
}


Foam::label Foam::fsi::scalarSurfaces::innerSample(const label facei) const
{
    const cartesianMesh& grid = objects_.grid();
    const levelSetUpdate& levelSet = objects_.levelSet();
    const scalarField& distance = levelSet.cellDistance();
    const label a = grid.haloIndex()[grid.mesh().faceOwner()[facei]];
    const label b = a + grid.stepAcross(facei);
    if (distance[a] != distance[b])
    {
        return distance[a] < distance[b] ? a : b;
    }
    return levelSet.objectAt(a) < levelSet.objectAt(b) ? b : a;
}


const Foam::fsi::scalarSurfaces::surface*
Foam::fsi::scalarSurfaces::permeableAt(const label facei) const
{
    const label objecti = objects_.levelSet().objectAt(innerSample(facei));
    if (objecti < 0)
    {
        return nullptr;
    }
    const surface& s = surfaces_[objects_.bodies().objectGroup(objecti)];
    return s.type == permeable ? &s : nullptr;
}


// ************************************************************************* //
