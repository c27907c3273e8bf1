// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangleSamples.H"
#include "lanePack.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Rows and samples side by side
static constexpr label width = 4;

//  ... as they lie in memory, and in registers
typedef lanePack<width>::type pack;
typedef double registers __attribute__((vector_size(width*sizeof(double))));

FSI_INLINE registers load(const scalar* from)
{
    return *reinterpret_cast<const pack*>(from);
}

FSI_INLINE void store(const registers& values, scalar* to)
{
    *reinterpret_cast<pack*>(to) = values;
}

//- The next multiple of the width
static label padded(const label n)
{
    return (n + width - 1)/width*width;
}


//- Limits of x in n rows, n a multiple of the width
FSI_AVX2_CLONES
static void rowLimits
(
    const triangleReach& reach,
    const label n,
    const scalar* y,
    const scalar z,
    scalar* lower,
    scalar* upper
)
{
    for (label i = 0; i < n; i += width)
    {
        registers from, to;
        reach.rows(load(y + i), z, from, to);
        store(from, lower + i);
        store(to, upper + i);
    }
}


//- Squared distances of n points from a triangle, n a multiple of the width
FSI_AVX2_CLONES
static void distances
(
    const triangleProjection& face,
    const label n,
    const scalar* x,
    const scalar* y,
    const scalar* z,
    scalar* distanceSqr
)
{
    for (label i = 0; i < n; i += width)
    {
        store
        (
            face.distanceSqr(load(x + i), load(y + i), load(z + i)),
            distanceSqr + i
        );
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::triangleSamples::reserve(const label n)
{
    const label needed = padded(size_ + n);
    if (needed > index_.size())
    {
        index_.setSize(2*needed);
        x_.setSize(2*needed, 0);
        y_.setSize(2*needed, 0);
        z_.setSize(2*needed, 0);
        distanceSqr_.setSize(2*needed);
    }
}


void Foam::fsi::triangleSamples::find
(
    const triangleReach& reach,
    const cartesianBlock& block
)
{
    const label firstRow = block.nUpTo(reach.bounds().min().y(), 1);
    const label endRow = block.nUpTo(reach.bounds().max().y(), 1);
    const label firstPlane = block.nUpTo(reach.bounds().min().z(), 2);
    const label endPlane = block.nUpTo(reach.bounds().max().z(), 2);

    const label nRows = padded(endRow - firstRow);
    rowY_.setSize(nRows);
    lower_.setSize(nRows);
    upper_.setSize(nRows);
    for (label j = 0; j < nRows; ++j)
    {
        rowY_[j] = block.latticePosition(block.start().y() + firstRow + j, 1);
    }

    size_ = 0;
    for (label k = firstPlane; k < endPlane; ++k)
    {
        const scalar z = block.latticePosition(block.start().z() + k, 2);
        rowLimits
        (
            reach, nRows, rowY_.cdata(), z, lower_.data(), upper_.data()
        );
        for (label j = 0; j < endRow - firstRow; ++j)
        {
            if (lower_[j] > upper_[j])
            {
                continue;
            }
            const label begin = block.nUpTo(lower_[j], 0);
            const label end = block.nUpTo(upper_[j], 0);
            const label row = block.index(0, firstRow + j, k);
            reserve(end - begin);
            for (label i = begin; i < end; ++i)
            {
                index_[size_] = row + i;
                x_[size_] = block.latticePosition(block.start().x() + i, 0);
                y_[size_] = rowY_[j];
                z_[size_] = z;
                ++size_;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::triangleSamples::update
(
    const triangleReach& reach,
    const triangleProjection& face,
    const cartesianBlock& block
)
{
    find(reach, block);
    distances
    (
        face,
        padded(size_),
        x_.cdata(),
        y_.cdata(),
        z_.cdata(),
        distanceSqr_.data()
    );
}


// ************************************************************************* //
