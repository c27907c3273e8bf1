// SPDX-License-Identifier: GPL-3.0-or-later

#include "populationCheck.H"
#include "globalMeshData.H"
#include "polygonPredicates.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static bool isFinite(const pointField& points)
{
    for (const point& p : points)
    {
        if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
        {
            return false;
        }
    }
    return true;
}


//- A line that names the objects of a fault, the first ones of many
template<class T>
static void writeFault
(
    Ostream& os,
    const char* what,
    const UList<T>& objects
)
{
    if (objects.empty())
    {
        return;
    }
    const label shown = min(objects.size(), label(10));
    os  << "    " << what << ':';
    for (label i = 0; i < shown; ++i)
    {
        os  << ' ' << objects[i];
    }
    os  << (shown < objects.size() ? " ..." : "") << nl;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * * Results * * * * * * * * * * * * * * * * //

Foam::label Foam::fsi::populationCheck::result::nFaults() const
{
    return
        overlapping.size() + crossing.size() + notFinite.size()
      + outside.size() + twice.size() + areaOff.size()
      + mag(nLost());
}


void Foam::fsi::populationCheck::result::write(Ostream& os) const
{
    os  << objects << " objects, "
        << overlapping.size() << " overlaps, "
        << crossing.size() << " crossing themselves, "
        << outside.size() << " outside, "
        << left << " left, " << nLost() << " lost, "
        << twice.size() << " double, area change " << areaChange << nl;

    writeFault(os, "Objects overlap", overlapping);
    writeFault(os, "Outlines cross themselves", crossing);
    writeFault(os, "Coordinates are not numbers", notFinite);
    writeFault(os, "Objects are outside the domain", outside);
    writeFault(os, "Ids are there twice", twice);
    writeFault(os, "Areas are off", areaOff);
    if (nLost() != 0)
    {
        os  << "    Objects are lost: " << left << " left, missing are "
            << missing.size() << nl;
        writeFault(os, "Missing objects", missing);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::populationCheck::populationCheck
(
    const fvMesh& mesh,
    const scalar areaTolerance
)
:
    sides_(mesh),
    spacing_
    (
        sqrt
        (
            sides_.bounds().span().x()*sides_.bounds().span().y()
           /mesh.globalData().nTotalCells()
        )
    ),
    areaTolerance_(areaTolerance)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::populationCheck::checkIds
(
    const population& objects,
    result& found
)
{
    labelList nCopies(objects.nextObjectId(), Zero);
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        const label id = objects.objectId(objecti);
        if (id < 0 || id >= nCopies.size() || nCopies[id]++ == 1)
        {
            found.twice.append(id);
        }
    }
    forAll(nCopies, id)
    {
        if (nCopies[id] == 0)
        {
            found.missing.append(id);
        }
    }
}


void Foam::fsi::populationCheck::checkAreas
(
    const population& objects,
    result& found
) const
{
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        const label groupi = objects.objectGroup(objecti);
        const scalar change = mag
        (
            objects.groups()[groupi].volume(objects.objectCopy(objecti))
           /objects.shape(groupi).referenceVolume()
          - 1
        );
        found.areaChange = max(found.areaChange, change);
        if (!(change <= areaTolerance_))
        {
            found.areaOff.append(objects.objectId(objecti));
        }
    }
}


bool Foam::fsi::populationCheck::isOutside(const boundBox& box) const
{
    const boundBox& domain = sides_.bounds();
    for (label sidei = 0; sidei < 4; ++sidei)
    {
        const direction d = sidei/2;
        const bool beyondWall =
            sidei % 2
          ? box.max()[d] > domain.max()[d]
          : box.min()[d] < domain.min()[d];
        if
        (
            (sides_[sidei] == domainSides::WALL && beyondWall)
         || (
                sides_[sidei] == domainSides::OPEN
             && sides_.beyond(sidei, box) > 3*spacing_
            )
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::fsi::populationCheck::checkOutlines
(
    const population& objects,
    result& found
) const
{
    DynamicList<pointField> outlines(objects.size());
    DynamicList<label> ids(objects.size());
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        const label id = objects.objectId(objecti);
        const pointField polygon
        (
            objects.surfaces().points(), objects.surfaces().loop(objecti)
        );
        if (!isFinite(polygon))
        {
            found.notFinite.append(id);
            continue;
        }
        const bool isFree =
            objects.groups()[objects.objectGroup(objecti)].free();
        if (isFree && isOutside(boundBox(polygon, false)))
        {
            found.outside.append(id);
        }
        if (!polygonPredicates::isSimple(polygon))
        {
            found.crossing.append(id);
            continue;
        }
        outlines.append(polygon);
        ids.append(id);
    }

    found.overlapping =
        polygonPredicates::overlapping(outlines, sides_.period());
    for (labelPair& pair : found.overlapping)
    {
        pair = labelPair(ids[pair.first()], ids[pair.second()]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::populationCheck::result
Foam::fsi::populationCheck::check
(
    const population& objects,
    const label nLeft
) const
{
    if (objects.nDims() != 2)
    {
        FatalErrorInFunction
            << "Objects are checked in two dimensions only"
            << exit(FatalError);
    }
    result found;
    found.objects = objects.size();
    found.left = nLeft;
    checkIds(objects, found);
    checkAreas(objects, found);
    checkOutlines(objects, found);
    return found;
}


// ************************************************************************* //
