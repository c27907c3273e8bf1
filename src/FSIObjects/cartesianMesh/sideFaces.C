// SPDX-License-Identifier: GPL-3.0-or-later

#include "sideFaces.H"
#include "labelVector.H"
#include "openfoamVersion.H"
#include "sumOverRanks.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

//- Faces of a side, periodic copies included
struct lattice
{
    //- Two directions in the side
    direction a;
    direction b;

    //- Faces along these
    label nA;
    label nB;

    //- Lower end, and the size of a face [m]
    point start;
    vector size;

    boolList open;

    //- Is a face open? Beyond an end the last one counts
    bool isOpen(const label i, const label j) const
    {
        const label inA = min(max(i, 0), nA - 1);
        const label inB = min(max(j, 0), nB - 1);
        return open[inA + nA*inB];
    }

    //- Corner of faces
    point corner(const label i, const label j) const
    {
        point p(start);
        p[a] += i*size[a];
        p[b] += j*size[b];
        return p;
    }
};

} // End anonymous namespace


//- Centres of the open faces of a side, of all ranks, and their largest size
static pointField openFaces
(
    const polyMesh& mesh,
    const label sidei,
    const UList<word>& openPatches,
    vector& size
)
{
    DynamicList<point> mine;
    size = Zero;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const label n = isIn(openPatches, patch.name()) ? patch.size() : 0;
        for (label i = 0; i < n; ++i)
        {
            if (sideFaces::isOn(sidei, mesh.bounds(), patch, i))
            {
                const boundBox face(patch[i].points(mesh.points()), false);
                mine.append(patch.faceCentres()[i]);
                size = max(size, face.span());
            }
        }
    }
    List<vector> largest(1, size);
    combineOverRanks(largest, maxEqOp<vector>());
    size = largest[0];
    pointField all;
    for (const pointField& ofRank : gatherOverRanks(pointField(mine)))
    {
        all.append(ofRank);
    }
    return all;
}


//- The lattice of a side
static lattice latticeOf
(
    const polyMesh& mesh,
    const label sidei,
    const vector& period,
    const UList<word>& openPatches
)
{
    const boundBox& bounds = mesh.bounds();
    const direction d = sidei/2;
    lattice faces;
    const pointField open(openFaces(mesh, sidei, openPatches, faces.size));
    faces.a = (d + 1) % 3;
    faces.b = (d + 2) % 3;
    faces.start = sidei % 2 ? bounds.max() : bounds.min();
    labelVector n(1, 1, 1);
    labelVector copies(1, 1, 1);
    for (const direction e : {faces.a, faces.b})
    {
        const scalar span = bounds.span()[e];
        n[e] = max(label(std::lround(span/max(faces.size[e], VSMALL))), 1);
        faces.size[e] = span/n[e];
        copies[e] = period[e] > 0 ? 3 : 1;
        faces.start[e] = bounds.min()[e] - copies[e]/2*span;
    }
    faces.nA = copies[faces.a]*n[faces.a];
    faces.nB = copies[faces.b]*n[faces.b];
    faces.open.setSize(faces.nA*faces.nB, false);
    for (const point& p : open)
    {
        labelVector at;
        for (const direction e : {faces.a, faces.b})
        {
            const scalar away = (p[e] - bounds.min()[e])/faces.size[e];
            at[e] = min(max(label(away), 0), n[e] - 1);
        }
        for (label i = at[faces.a]; i < faces.nA; i += n[faces.a])
        {
            for (label j = at[faces.b]; j < faces.nB; j += n[faces.b])
            {
                faces.open[i + faces.nA*j] = true;
            }
        }
    }
    return faces;
}


//- Cover the places (i, j) that are true by rectangles: runs of i, each over
//  all j on which it is the same. add(first i, end of i, first j, end of j)
template<class IsTrue, class Add>
static void cover
(
    const label ni,
    const label nj,
    const IsTrue& isTrue,
    const Add& add
)
{
    // First j of each run
    std::map<std::pair<label, label>, label> begun;
    for (label j = 0; j <= nj; ++j)
    {
        std::map<std::pair<label, label>, label> runs;
        for (label i = 0; i < ni && j < nj; ++i)
        {
            const label first = i;
            while (i < ni && isTrue(i, j))
            {
                ++i;
            }
            if (i > first)
            {
                const auto old = begun.find({first, i});
                runs[{first, i}] = old == begun.end() ? j : old->second;
            }
        }
        for (const auto& run : begun)
        {
            if (!runs.count(run.first))
            {
                add(run.first.first, run.first.second, run.second, j);
            }
        }
        begun = runs;
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::sideFaces::isOn
(
    const label sidei,
    const boundBox& bounds,
    const polyPatch& patch,
    const label facei
)
{
    // In a thin mesh all faces are near to the sides in z
    const direction d = sidei/2;
    const point& p = patch.faceCentres()[facei];
    const vector& S = patch.faceAreas()[facei];
    const scalar at = sidei % 2 ? bounds.max()[d] : bounds.min()[d];
    return mag(S[d]) >= 0.5*mag(S) && mag(p[d] - at) <= 1e-6*bounds.mag();
}


void Foam::fsi::sideFaces::check
(
    const boundBox& bounds,
    const polyPatch& patch,
    const label facei
)
{
    bool found = false;
    for (label sidei = 0; sidei < 6; ++sidei)
    {
        found = found || isOn(sidei, bounds, patch, facei);
    }
    if (!found)
    {
        FatalErrorInFunction
            << "Patch " << patch.name() << " in constant/polyMesh/boundary"
            << " has a face at " << patch.faceCentres()[facei]
            << ", inside the mesh's box " << bounds << nl
            << "Contact knows the sides of the box only. Make walls inside"
            << " of objects with motion { type fixed; }, merge blocks"
            << " that touch, and fill the box" << exit(FatalError);
    }
}


void Foam::fsi::sideFaces::leaveOpenings
(
    const polyMesh& mesh,
    const label sidei,
    const vector& period,
    const UList<word>& openPatches,
    contactWall& wall
)
{
    const lattice faces(latticeOf(mesh, sidei, period, openPatches));
    DynamicList<boundBox> parts;
    const auto add = [&](label i, label endI, label j, label endJ)
    {
        boundBox box(faces.corner(i, j), faces.corner(endI, endJ));
        const scalar far = sidei % 2 ? GREAT : -GREAT;
        (sidei % 2 ? box.max() : box.min())[sidei/2] = far;
        box.min()[faces.a] = i == 0 ? -GREAT : box.min()[faces.a];
        box.min()[faces.b] = j == 0 ? -GREAT : box.min()[faces.b];
        box.max()[faces.a] = endI == faces.nA ? GREAT : box.max()[faces.a];
        box.max()[faces.b] = endJ == faces.nB ? GREAT : box.max()[faces.b];
        for (const boundBox& part : parts)
        {
            if (part.contains(box))
            {
                return;
            }
        }
        parts.append(box);
    };
    cover
    (
        faces.nA, faces.nB,
        [&](label i, label j) { return !faces.isOpen(i, j); },
        [&](label i, label endI, label j, label endJ)
        {
            add(i, endI, j, endJ);
        }
    );
    cover
    (
        faces.nB, faces.nA,
        [&](label j, label i) { return !faces.isOpen(i, j); },
        [&](label j, label endJ, label i, label endI)
        {
            add(i, endI, j, endJ);
        }
    );
    DynamicList<point> rim;
    const bool plane = mesh.nSolutionD() == 2;
    for (label i = 0; i <= (plane && faces.a == 2 ? 0 : faces.nA); ++i)
    {
        for (label j = 0; j <= (plane && faces.b == 2 ? 0 : faces.nB); ++j)
        {
            const bool open = faces.isOpen(i, j);
            if
            (
                open != faces.isOpen(i - 1, j)
             || open != faces.isOpen(i, j - 1)
             || open != faces.isOpen(i - 1, j - 1)
            )
            {
                rim.append(faces.corner(i, j));
            }
        }
    }
    wall.setParts(parts, pointField(rim));
}


// ************************************************************************* //
