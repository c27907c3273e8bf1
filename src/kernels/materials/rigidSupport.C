// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidSupport.H"
#include "ListOps.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The point that is farthest from the first, or from the line through it
//  along a direction that is not zero
static label farthest(const pointField& points, const vector& direction)
{
    scalarField distances(points.size());
    forAll(points, pointi)
    {
        const vector d = points[pointi] - points[0];
        distances[pointi] = magSqr(d);
        if (magSqr(direction) > 0)
        {
            distances[pointi] -= sqr(d & direction)/magSqr(direction);
        }
    }
    return findMax(distances);
}


//- Component of a vector with the largest size
static label largestComponent(const vector& v)
{
    label largest = 0;
    for (label i = 1; i < 3; ++i)
    {
        largest = mag(v[i]) >= mag(v[largest]) ? i : largest;
    }
    return largest;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fsi::rigidSupport(const shapeMesh& mesh)
{
    const label nDims = mesh.nDims();
    const label far = farthest(mesh.points, Zero);
    const vector d = mesh.points[far] - mesh.points[0];

    labelList unknowns(identityList(nDims));
    for (label i = 0; i < nDims; ++i)
    {
        if (i != largestComponent(d))
        {
            unknowns.append(nDims*far + i);
        }
    }
    if (nDims == 3)
    {
        // The last unknown keeps the body from turning about d
        const label third = farthest(mesh.points, d);
        const vector turn = d ^ (mesh.points[third] - mesh.points[0]);
        unknowns.append(3*third + largestComponent(turn));
    }
    return unknowns;
}


// ************************************************************************* //
