// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockInterpolation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Find the sample below p and the part of the spacing beyond it
static bool locate
(
    const cartesianBlock& block,
    const point& p,
    labelVector& lower,
    vector& part
)
{
    lower = labelVector::zero;
    part = Zero;
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        const scalar first = block.latticePosition(block.start()[dir], dir);
        const scalar s = (p[dir] - first)/block.spacing();
        const label nCells = block.n()[dir] - 1;
        if (!(s >= 0 && s <= nCells))
        {
            return false;
        }
        lower[dir] = min(label(s), nCells - 1);
        part[dir] = s - lower[dir];
    }
    return true;
}


//- Weights of samples 0 to 3 at s (from sample 0, in spacings), and their
//  derivatives
static void cubicWeights
(
    const scalar s,
    FixedList<scalar, 4>& w,
    FixedList<scalar, 4>& dw
)
{
    const scalar a = s, b = s - 1, c = s - 2, d = s - 3;

    w[0] = -b*c*d/6;
    w[1] = a*c*d/2;
    w[2] = -a*b*d/2;
    w[3] = a*b*c/6;

    dw[0] = -(c*d + b*d + b*c)/6;
    dw[1] = (c*d + a*d + a*c)/2;
    dw[2] = -(b*d + a*d + a*b)/2;
    dw[3] = (b*c + a*c + a*b)/6;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::interpolateLinear
(
    const cartesianBlock& block,
    const scalarField& values,
    const point& p,
    scalar& value
)
{
    labelVector lower;
    vector part;
    if (!locate(block, p, lower, part))
    {
        return false;
    }

    value = 0;
    const label nCorners = 1 << block.nDims();
    for (label corner = 0; corner < nCorners; ++corner)
    {
        label samplei = block.index(lower);
        scalar weight = 1;
        for (direction dir = 0; dir < block.nDims(); ++dir)
        {
            const bool upper = corner & (1 << dir);
            samplei += upper ? block.stride(dir) : 0;
            weight *= upper ? part[dir] : 1 - part[dir];
        }
        value += weight*values[samplei];
    }
    return true;
}


bool Foam::fsi::interpolateCubic
(
    const cartesianBlock& block,
    const scalarField& values,
    const point& p,
    scalar& value,
    vector& gradient
)
{
    labelVector lower;
    vector part;
    if (!locate(block, p, lower, part))
    {
        return false;
    }

    FixedList<FixedList<scalar, 4>, 3> w, dw;
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        if (block.n()[dir] < 4)
        {
            return false;
        }
        const label first = max(min(lower[dir] - 1, block.n()[dir] - 4), 0);
        cubicWeights(lower[dir] - first + part[dir], w[dir], dw[dir]);
        lower[dir] = first;
    }

    // Sums over the rows along x are weighted in y and z
    value = 0;
    gradient = Zero;
    const bool flat = block.nDims() == 2;
    for (label k = 0; k < (flat ? 1 : 4); ++k)
    {
        const scalar wz = flat ? 1 : w[2][k];
        const scalar dwz = flat ? 0 : dw[2][k];
        for (label j = 0; j < 4; ++j)
        {
            const scalar* row =
                &values[block.index(lower + labelVector(0, j, k))];
            scalar sum = 0, dSum = 0;
            for (label i = 0; i < 4; ++i)
            {
                sum += w[0][i]*row[i];
                dSum += dw[0][i]*row[i];
            }
            value += wz*w[1][j]*sum;
            gradient.x() += wz*w[1][j]*dSum;
            gradient.y() += wz*dw[1][j]*sum;
            gradient.z() += dwz*w[1][j]*sum;
        }
    }
    gradient /= block.spacing();
    return true;
}


// ************************************************************************* //
