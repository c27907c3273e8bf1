// SPDX-License-Identifier: GPL-3.0-or-later

#include "staggeredTransfer.H"
#include "deltaKernel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using Foam::fsi::staggeredLattice;

//- Points of a kernel along a direction: distances in the array, and weights;
//  none if all are out of the block
template<int width>
struct pointsAlong
{
    label places[width];
    scalar weights[width];
    label n;

    void set
    (
        const staggeredLattice& lattice,
        const scalar place,
        const direction d
    )
    {
        if (d >= lattice.nDims)
        {
            n = 1;
            places[0] = 0;
            weights[0] = 1;
            return;
        }
        const fsi::deltaKernel<width> kernel(place);
        n = 0;
        for (label i = 0; i < width; ++i)
        {
            const label at = lattice.along(kernel.first + i, d);
            places[i] = at < 0 ? 0 : at*lattice.stride(d);
            weights[i] = at < 0 ? 0 : kernel.weights[i];
            n = at < 0 ? n : width;
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int width, class Action>
void Foam::fsi::staggeredTransfer::forWeights
(
    const point& x,
    const Action& action
) const
{
    // On the faces with the normal along a direction, and on the others
    pointsAlong<width> across[3], beside[3];
    const vector place((x - lattice_.origin)/lattice_.spacing);
    for (direction d = 0; d < 3; ++d)
    {
        across[d].set(lattice_, place[d], d);
        beside[d].set(lattice_, place[d] - 0.5, d);
        if (across[d].n == 0 && beside[d].n == 0)
        {
            return;
        }
    }
    for (direction d = 0; d < lattice_.nDims; ++d)
    {
        const pointsAlong<width>& px = d == 0 ? across[0] : beside[0];
        const pointsAlong<width>& py = d == 1 ? across[1] : beside[1];
        const pointsAlong<width>& pz = d == 2 ? across[2] : beside[2];
        // Loops of a fixed length, but for the third direction
        const label n = px.n > 0 && py.n > 0 ? pz.n : 0;
        for (label k = 0; k < n; ++k)
        {
            for (label j = 0; j < width; ++j)
            {
                const scalar w = pz.weights[k]*py.weights[j];
                const label row = pz.places[k] + py.places[j];
                for (label i = 0; i < width; ++i)
                {
                    action(d, row + px.places[i], w*px.weights[i]);
                }
            }
        }
    }
}


template<int width>
void Foam::fsi::staggeredTransfer::spreadWith
(
    const UList<point>& points,
    const UList<vector>& values,
    faceArrays& faces
) const
{
    forAll(points, nodei)
    {
        const vector& value = values[nodei];
        forWeights<width>
        (
            points[nodei],
            [&](const direction d, const label place, const scalar weight)
            {
                faces[d][place] += weight*value[d];
            }
        );
    }
}


template<int width>
void Foam::fsi::staggeredTransfer::interpolateWith
(
    const UList<point>& points,
    const faceArrays& faces,
    UList<vector>& values
) const
{
    forAll(points, nodei)
    {
        vector sum(Zero);
        forWeights<width>
        (
            points[nodei],
            [&](const direction d, const label place, const scalar weight)
            {
                sum[d] += weight*faces[d][place];
            }
        );
        values[nodei] = sum;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::staggeredTransfer::staggeredTransfer
(
    const staggeredLattice& lattice,
    const label width
)
:
    lattice_(lattice),
    width_(width)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::staggeredTransfer::spread
(
    const UList<point>& points,
    const UList<vector>& values,
    faceArrays& faces
) const
{
    switch (width_)
    {
        case 2: spreadWith<2>(points, values, faces); break;
        case 3: spreadWith<3>(points, values, faces); break;
        default: spreadWith<4>(points, values, faces);
    }
}


void Foam::fsi::staggeredTransfer::interpolate
(
    const UList<point>& points,
    const faceArrays& faces,
    UList<vector>& values
) const
{
    switch (width_)
    {
        case 2: interpolateWith<2>(points, faces, values); break;
        case 3: interpolateWith<3>(points, faces, values); break;
        default: interpolateWith<4>(points, faces, values);
    }
}


// ************************************************************************* //
