// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfacePlace.H"
#include "surfaceSet.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using Foam::fsi::surfaceSet;

//- The nearest of the places tried so far
struct nearestSoFar
{
    const Foam::fsi::surfaceSet& surfaces;
    const point& p;
    scalar distance = GREAT;
    label face = -1;
    FixedList<scalar, 3> weights = FixedList<scalar, 3>(scalar(0));

    //- Is a face nearer than the last ones? Of two at the same distance, to
    //  six digits of its square if there is a choice, the first one counts
    bool take(const label facei, const bool choice)
    {
        FixedList<scalar, 3> there;
        const scalar away =
            magSqr(surfaces.nearestOnFace(facei, p, there) - p);
        const scalar same = !choice ? 1 : facei < face ? 1 + 1e-6 : 1 - 1e-6;
        // Neither is one at a distance that is not a number
        if (!(away < same*distance))
        {
            return false;
        }
        distance = away;
        face = facei;
        weights = there;
        return true;
    }

    //- Go on to a face that shares the edge or node at which the place lies,
    //  if that face is nearer
    bool step()
    {
        label nZero = 0;
        for (label i = 0; i < surfaces.nNodes(); ++i)
        {
            if (weights[i] <= 0)
            {
                const label next = surfaces.faceAcross(face, i);
                if (next >= 0 && take(next, false))
                {
                    return true;
                }
                ++nZero;
            }
        }
        if (nZero < 2)
        {
            return false;
        }
        DynamicList<label> about;
        Foam::fsi::appendFacesAt(surfaces, face, weights, about);
        for (const label next : about)
        {
            if (take(next, false))
            {
                return true;
            }
        }
        return false;
    }
};

//- The face after a face and the last one, about a node; -1 if there is none
label nextAbout
(
    const surfaceSet& surfaces,
    const label nodei,
    const label facei,
    const label last
)
{
    for (label i = 0; i < surfaces.nNodes(); ++i)
    {
        const label next = surfaces.faceAcross(facei, i);
        if (surfaces.faces()[facei][i] != nodei && next != last)
        {
            return next;
        }
    }
    return -1;
}

//- Has the angle between two faces at least this cosine?
bool turnsLess
(
    const surfaceSet& surfaces,
    const label a,
    const label b,
    const scalar leastCosine
)
{
    if (leastCosine <= -1)
    {
        return true;
    }
    const vector n(surfaces.areaNormal(a));
    const vector other(surfaces.areaNormal(b));
    return (n & other) >= leastCosine*mag(n)*mag(other);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::surfacePlace Foam::fsi::nearestPlace
(
    const surfaceSet& surfaces,
    const point& p,
    const UList<label>& faces,
    label& found
)
{
    nearestSoFar nearest{surfaces, p};
    for (const label facei : faces)
    {
        if (facei >= 0 && facei != nearest.face)
        {
            nearest.take(facei, true);
        }
    }
    if (nearest.face < 0)
    {
        FatalErrorInFunction
            << "No surface near the wall at " << p
            << exit(FatalError);
    }
    while (nearest.step())
    {}

    surfacePlace place;
    place.face = nearest.face;
    place.weights = nearest.weights;
    // A place that is found on an image belongs to its original
    found = place.face;
    place.nodes = surfaces.faces()[place.face];
    for (label& nodei : place.nodes)
    {
        nodei = surfaces.originalNode(nodei);
    }
    place.object = surfaces.original(surfaces.faceObject()[place.face]);
    place.face = surfaces.originalFace(place.face);
    return place;
}


Foam::fsi::surfacePlace Foam::fsi::nearestPlace
(
    const surfaceSet& surfaces,
    const point& p,
    const label faceA,
    const label faceB,
    label& found
)
{
    FixedList<label, 2> faces{faceA, faceB};
    return nearestPlace(surfaces, p, UList<label>(faces.data(), 2), found);
}


void Foam::fsi::appendFacesAt
(
    const surfaceSet& surfaces,
    const label facei,
    const FixedList<scalar, 3>& weights,
    DynamicList<label>& faces,
    const scalar leastCosine
)
{
    faces.append(facei);
    label nZero = 0;
    label node = -1;
    for (label i = 0; i < surfaces.nNodes(); ++i)
    {
        const bool zero = weights[i] <= 0;
        nZero += zero;
        node = zero ? node : surfaces.faces()[facei][i];
    }

    // From either side, since the way about a node ends at a border
    bool round = false;
    for (label i = surfaces.nNodes() - 1; i >= 0 && !round; --i)
    {
        label last = facei;
        label next = weights[i] <= 0 ? surfaces.faceAcross(facei, i) : -1;
        while
        (
            next >= 0
         && next != facei
         && turnsLess(surfaces, last, next, leastCosine)
        )
        {
            faces.append(next);
            const label after =
                nZero < 2 ? -1 : nextAbout(surfaces, node, next, last);
            last = next;
            next = after;
        }
        round = next == facei;
    }
}


// ************************************************************************* //
