// SPDX-License-Identifier: GPL-3.0-or-later

#include "curvedSurface.H"
#include "surfacePlace.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Least cosine of the angle by which the surface turns at an edge that is not
//  sharp: of 40 degrees
static const scalar leastCosine = 0.766;

//- Weights of a node of a face
static FixedList<scalar, 3> nodeWeights(const label i)
{
    FixedList<scalar, 3> weights(scalar(0));
    weights[i] = 1;
    return weights;
}

//- Max's weight of a face's area normal at a node
static scalar nodeWeight
(
    const surfaceSet& surfaces,
    const label facei,
    const label nodei
)
{
    scalar product = 1;
    for (label i = 0; i < surfaces.nNodes(); ++i)
    {
        const label other = surfaces.faces()[facei][i];
        if (other != nodei)
        {
            const pointField& x = surfaces.points();
            product *= max(magSqr(x[other] - x[nodei]), VSMALL);
        }
    }
    return 1/product;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::curvedSurface::findAbout
(
    const label facei,
    const FixedList<scalar, 3>& weights
)
{
    near_.clear();
    appendFacesAt(surfaces_, facei, weights, near_);
    const label nAll = near_.size();
    near_.clear();
    appendFacesAt(surfaces_, facei, weights, near_, leastCosine);
    return near_.size() < nAll;
}


Foam::label Foam::fsi::curvedSurface::add(const label facei)
{
    const auto found = place_.find(facei);
    if (found != place_.end())
    {
        return *found;
    }
    const label nNodes = surfaces_.nNodes();
    const surfaceFace& f = surfaces_.faces()[facei];
    const pointField& x = surfaces_.points();
    curvedFace c;
    c.known = false;
    c.mean = 0;
    c.heights = FixedList<scalar, 3>(scalar(0));
    c.bends = c.heights;
    c.sharp = FixedList<bool, 3>(false);
    for (label i = 0; i < nNodes; ++i)
    {
        c.sharp[i] = findAbout(facei, nodeWeights(i));
        vector sum(Zero);
        for (const label next : near_)
        {
            sum +=
                nodeWeight(surfaces_, next, f[i])*surfaces_.areaNormal(next);
        }
        c.normals[i] = normalised(sum);
    }
    for (label i = 0; i < nNodes; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            const label third = 3 - i - j;
            if (third < nNodes)
            {
                FixedList<scalar, 3> middle(scalar(0.5));
                middle[third] = 0;
                if (findAbout(facei, middle))
                {
                    continue;
                }
            }
            c.bends[third] =
                0.5*((c.normals[i] - c.normals[j]) & (x[f[i]] - x[f[j]]));
            c.mean += c.bends[third]/(nNodes*(nNodes + 1));
        }
    }
    place_.insert(facei, curved_.size());
    curved_.append(c);
    return curved_.size() - 1;
}


const Foam::fsi::curvedSurface::curvedFace& Foam::fsi::curvedSurface::at
(
    const label facei
)
{
    const label place = add(facei);
    for (label i = 0; i < surfaces_.nNodes() && !curved_[place].known; ++i)
    {
        if (curved_[place].sharp[i])
        {
            continue;
        }
        findAbout(facei, nodeWeights(i));
        const DynamicList<label> about(near_);
        scalar height = 0;
        scalar area = 0;
        for (const label next : about)
        {
            const scalar its = mag(surfaces_.areaNormal(next));
            height -= its*curved_[add(next)].mean;
            area += its;
        }
        curved_[place].heights[i] = height/max(area, VSMALL);
    }
    curved_[place].known = true;
    return curved_[place];
}


Foam::vector Foam::fsi::curvedSurface::meanNormal
(
    const label facei,
    const FixedList<scalar, 3>& weights
)
{
    near_.clear();
    appendFacesAt(surfaces_, facei, weights, near_);
    vector sum(Zero);
    for (const label next : near_)
    {
        sum += normalised(surfaces_.areaNormal(next));
    }
    return normalised(sum);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::curvedSurface::distance
(
    const label facei,
    const FixedList<scalar, 3>& weights,
    const vector& way,
    vector& normal
)
{
    const curvedFace& c = at(facei);
    const scalar away = mag(way);
    if (isIn(c.sharp, true) && findAbout(facei, weights))
    {
        normal = meanNormal(facei, weights);
        const scalar sign = (way & normal) < 0 ? -1 : 1;
        const bool touches = sqr(away) < SMALL*mag(surfaces_.areaNormal(facei));
        normal = touches ? normal : sign*way/away;
        return sign*away;
    }
    normal = Zero;
    scalar height = 0;
    for (label i = 0; i < surfaces_.nNodes(); ++i)
    {
        normal += weights[i]*c.normals[i];
        height += weights[i]*c.heights[i];
        for (label j = 0; j < i; ++j)
        {
            height += weights[i]*weights[j]*c.bends[3 - i - j];
        }
    }
    normal = normalised(normal);
    return ((way & normal) < 0 ? -away : away) - height;
}


// ************************************************************************* //
