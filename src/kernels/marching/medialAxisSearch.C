// SPDX-License-Identifier: GPL-3.0-or-later

#include "medialAxisSearch.H"
#include "addToRunTimeSelectionTable.H"
#include "Switch.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(medialAxisSearch, 0);
    addToRunTimeSelectionTable(contactSearch, medialAxisSearch, dictionary);

    //- Sort and keep one of each
    template<class Type>
    static void makeUnique(DynamicList<Type>& list)
    {
        std::sort(list.begin(), list.end());
        list.resize(std::unique(list.begin(), list.end()) - list.begin());
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::medialAxisSearch::medialAxisSearch(const dictionary& dict)
:
    contactSearch(dict)
{
    if (dict.lookupOrDefault<Switch>("selfContact", false))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'selfContact' in dictionary " << dict.name() << " is on,"
            << " but type medialAxis finds no pairs within one object: take"
            << " surfaceTree" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::medialAxisSearch::findNear
(
    const surfaceSet& surfaces,
    const medialAxisPoint& p,
    const scalar range
)
{
    for (label side = 0; side < 2; ++side)
    {
        const label objecti = p.object[side];
        if (objecti < 0 || objecti >= surfaces.size())
        {
            FatalErrorInFunction
                << "The medial axis names object " << objecti
                << ", there are " << surfaces.size() << exit(FatalError);
        }
        near_[side].clear();
        const label end = surfaces.pointStart()[objecti + 1];
        for (label i = surfaces.pointStart()[objecti]; i < end; ++i)
        {
            vector apart(surfaces.points()[i] - p.position);
            if (surfaces.nDims() == 2)
            {
                apart.z() = 0;
            }
            if (magSqr(apart) < sqr(range))
            {
                near_[side].append(i);
            }
        }
    }
}


void Foam::fsi::medialAxisSearch::connectFaces(const surfaceSet& surfaces)
{
    const List<surfaceFace>& faces = surfaces.faces();
    const label nNodes = surfaces.nNodes();

    faceStart_.setSize(surfaces.points().size() + 1);
    faceStart_ = 0;
    for (const surfaceFace& f : faces)
    {
        for (label i = 0; i < nNodes; ++i)
        {
            ++faceStart_[f[i]];
        }
    }
    for (label i = 1; i < faceStart_.size(); ++i)
    {
        faceStart_[i] += faceStart_[i - 1];
    }
    nodeFaces_.setSize(nNodes*faces.size());
    forAll(faces, facei)
    {
        for (label i = 0; i < nNodes; ++i)
        {
            nodeFaces_[--faceStart_[faces[facei][i]]] = facei;
        }
    }
}


void Foam::fsi::medialAxisSearch::combine(DynamicList<labelPair>& nodePairs)
{
    for (label side = 0; side < 2; ++side)
    {
        for (const label nodei : near_[side])
        {
            for (const label otherNode : near_[1 - side])
            {
                if (side == 0)
                {
                    nodePairs.append(labelPair(nodei, otherNode));
                }
                for
                (
                    label i = faceStart_[otherNode];
                    i < faceStart_[otherNode + 1];
                    ++i
                )
                {
                    candidates_.append(labelPair(nodei, nodeFaces_[i]));
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::medialAxisSearch::find
(
    const surfaceSet& surfaces,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis,
    const scalar range,
    contactPairs& found
)
{
    found.clear();
    candidates_.clear();
    geometry_.update(surfaces);
    connectFaces(surfaces);

    for (const medialAxisPoint& p : medialAxis)
    {
        findNear(surfaces, p, range);
        combine(found.nodePairs);
    }
    makeUnique(found.nodePairs);
    makeUnique(candidates_);

    label next = 0;
    forAll(surfaces.points(), nodei)
    {
        for (; next < candidates_.size(); ++next)
        {
            if (candidates_[next].first() != nodei)
            {
                break;
            }
            geometry_.consider
            (
                surfaces, nodei, candidates_[next].second(), range
            );
        }
        geometry_.append(surfaces, nodei, found.pairs);
        contactGeometry::appendWalls
        (
            surfaces.points()[nodei], nodei, walls, range, found.pairs
        );
    }
}


// ************************************************************************* //
