// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshFaults.H"
#include "errorOf.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace meshFaults
{

static string numbered(const char* what, const label i)
{
    return string(what) + " " + Foam::name(i);
}


//- Faults of a patch that is to start at a face
static string ofPatch
(
    const entry& patch,
    const label start,
    const label nFaces,
    label& end
)
{
    const string name("patch '" + patch.keyword() + "'");
    if (!patch.isDict())
    {
        return name + " is no dictionary";
    }
    label startFace = -1;
    label n = -1;
    const caughtError error = errorOf
    (
        [&]()
        {
            startFace = getEntry<label>(patch.dict(), "startFace");
            n = getEntry<label>(patch.dict(), "nFaces");
            getEntry<word>(patch.dict(), "type");
            if (patch.dict().found("inGroups"))
            {
                getEntry<wordList>(patch.dict(), "inGroups");
            }
        }
    );
    if (!error.message.empty())
    {
        return name + ": " + error.message;
    }
    if (startFace != start || n < 0 || n > nFaces - start)
    {
        return
            name + " must have startFace " + Foam::name(start)
          + " and nFaces of at most the " + Foam::name(nFaces - start)
          + " that are left";
    }
    end = start + n;
    return string();
}

} // End namespace meshFaults
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsi::meshFaults::ofPoints(const pointField& points)
{
    forAll(points, pointi)
    {
        if (!isUsable(points[pointi]))
        {
            return
                numbered("point", pointi)
              + " has a coordinate that is no number below 1e15";
        }
    }
    return string();
}


Foam::string Foam::fsi::meshFaults::ofFaces
(
    const faceList& faces,
    const label nPoints
)
{
    forAll(faces, facei)
    {
        const face& corners = faces[facei];
        bool sound = corners.size() >= 3;
        forAll(corners, i)
        {
            sound = sound && corners[i] >= 0 && corners[i] < nPoints;
            for (label j = 0; j < i; ++j)
            {
                sound = sound && corners[j] != corners[i];
            }
        }
        if (!sound)
        {
            return
                numbered("face", facei) + " has fewer than three points, a"
                " point twice, or one that the mesh does not have";
        }
    }
    return string();
}


Foam::string Foam::fsi::meshFaults::ofLabels
(
    const labelList& cells,
    const label nFaces
)
{
    if (cells.size() > nFaces)
    {
        return "more entries than there are faces";
    }
    forAll(cells, facei)
    {
        // There are not more cells than faces
        if (cells[facei] < 0 || cells[facei] >= nFaces)
        {
            return numbered("face", facei) + " has no such cell";
        }
    }
    return string();
}


Foam::string Foam::fsi::meshFaults::ofNeighbours
(
    const labelList& owner,
    const labelList& neighbour
)
{
    forAll(neighbour, facei)
    {
        const bool sorted =
            facei == 0
         || owner[facei - 1] < owner[facei]
         || (
                owner[facei - 1] == owner[facei]
             && neighbour[facei - 1] < neighbour[facei]
            );
        if (neighbour[facei] <= owner[facei] || !sorted)
        {
            return
                numbered("face", facei)
              + " is not in the order of owner and neighbour (renumberMesh"
                " sorts a sound mesh)";
        }
    }
    return string();
}


Foam::string Foam::fsi::meshFaults::ofOwners
(
    const labelList& owner,
    const labelList& neighbour,
    const label nFaces
)
{
    if (owner.size() != nFaces)
    {
        return
            Foam::name(owner.size()) + " entries for " + Foam::name(nFaces)
          + " faces";
    }
    labelList nFacesOf(nFaces, Zero);
    label nCells = 0;
    for (const labelList* cells : {&owner, &neighbour})
    {
        for (const label celli : *cells)
        {
            ++nFacesOf[celli];
            nCells = max(nCells, celli + 1);
        }
    }
    for (label celli = 0; celli < nCells; ++celli)
    {
        if (nFacesOf[celli] < 4)
        {
            return numbered("cell", celli) + " has fewer than four faces";
        }
    }
    return string();
}


Foam::string Foam::fsi::meshFaults::ofPatches
(
    const PtrList<entry>& patches,
    const label nInternal,
    const label nFaces
)
{
    label next = nInternal;
    for (const entry& patch : patches)
    {
        const string fault(ofPatch(patch, next, nFaces, next));
        if (!fault.empty())
        {
            return fault;
        }
    }
    if (next != nFaces)
    {
        return
            "its patches end at face " + Foam::name(next) + " of "
          + Foam::name(nFaces);
    }
    return string();
}


// ************************************************************************* //
