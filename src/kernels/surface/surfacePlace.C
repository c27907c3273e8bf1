// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfacePlace.H"
#include "surfaceSet.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

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
        if (away >= same*distance)
        {
            return false;
        }
        distance = away;
        face = facei;
        weights = there;
        return true;
    }

    //- Go on to a face across an edge, or a node of an outline, at which the
    //  place lies, if that face is nearer
    bool step()
    {
        for (label i = 0; i < surfaces.nNodes(); ++i)
        {
            if (weights[i] <= 0)
            {
                const label next = surfaces.faceAcross(face, i);
                if (next >= 0 && take(next, false))
                {
                    return true;
                }
            }
        }
        return false;
    }
};

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


// ************************************************************************* //
