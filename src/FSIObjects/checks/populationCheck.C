// SPDX-License-Identifier: GPL-3.0-or-later

#include "populationCheck.H"
#include "globalMeshData.H"
#include "surfacePredicates.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static bool isFinite(const UList<point>& points)
{
    for (const point& p : points)
    {
        if
        (
            !std::isfinite(p.x()) || !std::isfinite(p.y())
         || !std::isfinite(p.z())
        )
        {
            return false;
        }
    }
    return true;
}


//- Edge length of the cells of a box [m]
static scalar cellSize
(
    const boundBox& bounds,
    const direction nDims,
    const fvMesh& mesh
)
{
    const vector span(bounds.span());
    const label n = mesh.globalData().nTotalCells();
    return
        nDims == 2 ? sqrt(span.x()*span.y()/n) : cbrt(cmptProduct(span)/n);
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
        << twice.size() << " double, "
        << (nDims == 2 ? "area" : "volume") << " change " << areaChange << nl;

    writeFault(os, "Objects overlap", overlapping);
    writeFault
    (
        os,
        nDims == 2 ? "Outlines cross themselves" : "Surfaces cut themselves",
        crossing
    );
    writeFault(os, "Coordinates are not numbers", notFinite);
    writeFault(os, "Objects are outside the domain", outside);
    writeFault(os, "Ids are there twice", twice);
    writeFault(os, nDims == 2 ? "Areas are off" : "Volumes are off", areaOff);
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
    nDims_(direction(mesh.nSolutionD())),
    spacing_(cellSize(sides_.bounds(), nDims_, mesh)),
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


bool Foam::fsi::populationCheck::isOutside(const UList<point>& points) const
{
    if (sides_.behindWall(points))
    {
        return true;
    }
    const boundBox box(points, false);
    for (label sidei = 0; sidei < 2*nDims_; ++sidei)
    {
        if (sides_.isOpen(sidei) && sides_.beyond(sidei, box) > 3*spacing_)
        {
            return true;
        }
    }
    return false;
}


void Foam::fsi::populationCheck::checkSurfaces
(
    const population& objects,
    result& found
) const
{
    const surfaceSet& surfaces = objects.surfaces();
    const labelList& start = surfaces.pointStart();
    DynamicList<label> simple(objects.size());
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        const label id = objects.objectId(objecti);
        const SubList<point> points
        (
            surfaces.points(), start[objecti + 1] - start[objecti],
            start[objecti]
        );
        if (!isFinite(points))
        {
            found.notFinite.append(id);
            continue;
        }
        const bodyGroup& group =
            objects.groups()[objects.objectGroup(objecti)];
        const bool isFree =
            group.movesFreely() && group.shape().held().clamped().empty();
        if (isFree && isOutside(points))
        {
            found.outside.append(id);
        }
        if (surfacePredicates::cutsItself(surfaces, objecti))
        {
            found.crossing.append(id);
            continue;
        }
        simple.append(objecti);
    }

    found.overlapping =
        surfacePredicates::overlapping(surfaces, simple, sides_.period());
    for (labelPair& pair : found.overlapping)
    {
        pair = labelPair
        (
            objects.objectId(pair.first()), objects.objectId(pair.second())
        );
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
    if (objects.nDims() != nDims_)
    {
        FatalErrorInFunction
            << "The objects have " << label(objects.nDims())
            << " dimensions, the mesh " << label(nDims_)
            << exit(FatalError);
    }
    result found;
    found.nDims = nDims_;
    found.objects = objects.size();
    found.left = nLeft;
    checkIds(objects, found);
    checkAreas(objects, found);
    checkSurfaces(objects, found);
    return found;
}


// ************************************************************************* //
