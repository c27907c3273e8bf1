// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "curvedSurface.H"
#include "samples/surfaceSamples.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Weights of places on a face: inside, on edges and at nodes
List<FixedList<scalar, 3>> places(const direction nDims)
{
    if (nDims == 2)
    {
        return
            List<FixedList<scalar, 3>>({{0, 1, 0}, {0.3, 0.7, 0}, {1, 0, 0}});
    }
    return List<FixedList<scalar, 3>>
    ({
        {0.3, 0.3, 0.4}, {0.6, 0.1, 0.3}, {0, 0.4, 0.6}, {0.2, 0, 0.8},
        {0.7, 0.3, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}
    });
}


FixedList<scalar, 3> nodeWeights(const label i)
{
    FixedList<scalar, 3> weights(scalar(0));
    weights[i] = 1;
    return weights;
}


//- At the edge opposite to a node
FixedList<scalar, 3> edgeWeights(const label i)
{
    FixedList<scalar, 3> weights(scalar(0));
    weights[(i + 1) % 3] = 0.2;
    weights[(i + 2) % 3] = 0.8;
    return weights;
}


//- Height of the surface over a place
scalar height
(
    curvedSurface& curved,
    const label facei,
    const FixedList<scalar, 3>& weights,
    vector& normal
)
{
    return -curved.distance(facei, weights, Zero, normal);
}


//- A disc or a sphere of the radius 2 about (1 2 0)
surfaceSet round(const direction nDims, const label level)
{
    surfaceSet surfaces(nDims);
    if (nDims == 2)
    {
        appendDisc(surfaces, point(1, 2, 0), 2, 8 << level);
    }
    else
    {
        appendSphere(surfaces, point(1, 2, 0), 2, level);
    }
    return surfaces;
}


//- A round body with its nodes moved and made longer, so that no faces are
//  equal
surfaceSet uneven(const direction nDims)
{
    const surfaceSet from(round(nDims, 3));
    pointField nodes(from.points());
    for (point& x : nodes)
    {
        const vector r(x - point(1, 2, 0));
        const vector moved
        (
            r.x() + 0.15*r.y()*r.x(), r.y() + 0.1*r.x(), r.z()*(1 + 0.1*r.y())
        );
        x = 2*moved/mag(moved);
        x.x() *= 1.4;
    }
    surfaceSet surfaces(nDims);
    surfaces.append(nodes, from.faces());
    return surfaces;
}


//- A box with the sides 1, 2 and 3, each of two triangles
surfaceSet box()
{
    surfaceSet surfaces(3);
    surfaces.append
    (
        pointField
        ({
            {0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0},
            {0, 0, 3}, {1, 0, 3}, {0, 2, 3}, {1, 2, 3}
        }),
        List<surfaceFace>
        ({
            {0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
            {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
            {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}
        })
    );
    return surfaces;
}

} // End anonymous namespace


TEST(CurvedSurface, isARoundBody)
{
    for (const direction nDims : {2, 3})
    {
        for (label level = 2; level < 5; ++level)
        {
            const surfaceSet surfaces(round(nDims, level));
            curvedSurface curved(surfaces);
            scalar turned = 0, ofFaces = 0, least = GREAT, most = -GREAT;
            scalar below = 0;
            forAll(surfaces.faces(), facei)
            {
                const vector flat(normalised(surfaces.areaNormal(facei)));
                for (const FixedList<scalar, 3>& weights : places(nDims))
                {
                    const vector r
                    (
                        surfaces.interpolate(surfaces.points(), facei, weights)
                      - point(1, 2, 0)
                    );
                    vector n;
                    const scalar z = height(curved, facei, weights, n);
                    EXPECT_NEAR(mag(n), 1, 1e-14);
                    turned = max(turned, mag(n - r/mag(r)));
                    ofFaces = max(ofFaces, mag(flat - r/mag(r)));
                    least = min(least, mag(r) + z);
                    most = max(most, mag(r) + z);
                    below = max(below, 2 - mag(r));
                }
            }
            // Its radius is one at which it has the volume of the facets
            EXPECT_LT(turned, nDims == 2 ? 1e-13 : 0.1*ofFaces) << level;
            EXPECT_LT(most - least, (nDims == 2 ? 0.02 : 0.4)*below) << level;
            EXPECT_LT(most, 2);
        }
    }
}


TEST(CurvedSurface, doesNotJumpBetweenFaces)
{
    for (const direction nDims : {2, 3})
    {
        const surfaceSet surfaces(uneven(nDims));
        curvedSurface curved(surfaces);
        for (label i = 0; i < 3*surfaces.faces().size(); ++i)
        {
            // At an edge, not in its middle; in 2D at a node
            const label facei = i/3;
            const FixedList<scalar, 3> here
            (
                nDims == 2
              ? nodeWeights(i % 2)
              : edgeWeights(i % 3)
            );
            const label next =
                surfaces.faceAcross(facei, nDims == 2 ? 1 - i % 2 : i % 3);
            FixedList<scalar, 3> there(scalar(0));
            for (label j = 0; j < surfaces.nNodes(); ++j)
            {
                const label nodei = surfaces.faces()[facei][j];
                for (label k = 0; k < surfaces.nNodes(); ++k)
                {
                    if (surfaces.faces()[next][k] == nodei)
                    {
                        there[k] = here[j];
                    }
                }
            }
            vector n, other;
            const scalar z = height(curved, facei, here, n);
            EXPECT_NEAR(z, height(curved, next, there, other), 1e-14);
            EXPECT_NEAR(mag(n - other), 0, 1e-13);
        }
    }
}


TEST(CurvedSurface, hasTheVolumeOfTheFacets)
{
    for (const direction nDims : {2, 3})
    {
        const surfaceSet surfaces(uneven(nDims));
        curvedSurface curved(surfaces);
        scalar volume = 0, bent = 0;
        forAll(surfaces.faces(), facei)
        {
            // Exact for squares, from the nodes and the middles of edges
            vector n;
            scalar mean = 0;
            for (label i = 0; i < 3 && nDims == 3; ++i)
            {
                FixedList<scalar, 3> middle(scalar(0.5));
                middle[i] = 0;
                mean += height(curved, facei, middle, n)/3;
            }
            for (label i = 0; i < 2 && nDims == 2; ++i)
            {
                mean += height(curved, facei, nodeWeights(i), n)/6;
                mean += height(curved, facei, {0.5, 0.5, 0}, n)/3;
            }
            const scalar area = mag(surfaces.areaNormal(facei));
            volume += area*mean;
            bent += area*mag(height(curved, facei, nodeWeights(0), n));
        }
        EXPECT_GT(bent, 0.01);
        EXPECT_NEAR(volume, 0, 1e-12*bent);
    }
}


TEST(CurvedSurface, keepsTheEdgesOfABox)
{
    const surfaceSet surfaces(box());
    curvedSurface curved(surfaces);
    const point inside(0.9, 1.95, 1);
    const pointField all
    ({
        {1.2, 0.7, 3.5}, {-0.1, -0.2, 3.3}, {0.5, 2.5, 3}, {0.5, 2.5, 3.1},
        inside
    });
    for (const point& p : all)
    {
        const scalar least = bruteDistance(surfaces, p);
        forAll(surfaces.faces(), facei)
        {
            FixedList<scalar, 3> weights;
            const vector way(p - surfaces.nearestOnFace(facei, p, weights));
            if (mag(way) < least + 1e-12)
            {
                vector normal;
                const scalar d = curved.distance(facei, weights, way, normal);
                EXPECT_NEAR(d, p == inside ? -least : least, 1e-14);
                EXPECT_NEAR(mag(d*normal - way), 0, 1e-14);
            }
        }
    }
}
