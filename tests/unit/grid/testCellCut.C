// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "cellCut.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Count the middles of n^nDims parts of the cell
static scalar countedPart
(
    const vector& normal,
    const scalar distance,
    const direction nDims,
    const label n
)
{
    const vector e(normal/mag(normal));
    const label nZ = nDims == 3 ? n : 1;
    label closed = 0;
    for (label i = 0; i < n*n*nZ; ++i)
    {
        const vector x
        (
            (i % n + 0.5)/n - 0.5,
            (i/n % n + 0.5)/n - 0.5,
            nDims == 3 ? (i/(n*n) + 0.5)/n - 0.5 : 0
        );
        closed += (e & x) > distance;
    }
    return scalar(closed)/(n*n*nZ);
}


TEST(cellCut, isThePartBeyondThePlane)
{
    const vector normals[] =
    {
        {1, 0, 0}, {0, -3, 0}, {1, 1, 0}, {-0.3, 1, 0}, {0.01, 1, 0},
        {1, 1, 1}, {0.2, -0.5, 1}, {1e-4, 1, -0.4}, {0, 0, 1}
    };
    for (const vector& normal : normals)
    {
        for (const direction nDims : {2, 3})
        {
            if (nDims == 2 && normal.z() != 0)
            {
                continue;
            }
            const label n = nDims == 2 ? 400 : 60;
            for (scalar d = -0.9; d < 0.95; d += 0.13)
            {
                EXPECT_NEAR
                (
                    closedPartOfCell(normal, d, nDims),
                    countedPart(normal, d, nDims, n),
                    2.0/n
                ) << normal.x() << " " << normal.y() << " " << d;
            }
        }
    }
}


TEST(cellCut, isHalfAtTheCentreAndTheTwoSidesAddUp)
{
    for (const direction nDims : {2, 3})
    {
        for (const vector& normal : {vector(1, 0, 0), vector(0.3, -0.7, 0.1)})
        {
            EXPECT_NEAR(closedPartOfCell(normal, 0, nDims), 0.5, 1e-9);
            EXPECT_EQ(closedPartOfCell(normal, 0.9, nDims), 0);
            EXPECT_EQ(closedPartOfCell(normal, -0.9, nDims), 1);
            for (const scalar d : {0.01, 0.2, 0.4})
            {
                EXPECT_NEAR
                (
                    closedPartOfCell(normal, d, nDims)
                  + closedPartOfCell(normal, -d, nDims),
                    1,
                    1e-12
                );
            }
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// ************************************************************************* //
