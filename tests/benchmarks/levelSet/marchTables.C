// SPDX-License-Identifier: GPL-3.0-or-later

#include "levelSetTables.H"
#include "marching/reinitialisationCases.H"

#include <cstdio>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

void marchTable()
{
    std::printf
    (
        "March from exact values in 2 h, mean error in [-1, 1]^d\n"
        "%-10s %5s %10s %6s %10s %6s %14s %6s\n",
        "shape", "n", "order 1", "", "order 2", "", "2, cubic seeds", ""
    );
    struct shape
    {
        const char* name;
        pointFunction distance;
        direction nDims;
        std::vector<label> n;
    };
    const shape shapes[] =
    {
        {"circle", circleDistance, 2, {32, 64, 128, 256, 512}},
        {"square", squareDistance, 2, {32, 64, 128, 256, 512}},
        {"two discs", twoDiscsDistance, 2, {32, 64, 128, 256, 512}},
        {"sphere", circleDistance, 3, {16, 32, 64, 128}}
    };
    for (const shape& s : shapes)
    {
        FixedList<scalar, 3> coarse(0.0);
        for (const label n : s.n)
        {
            const FixedList<scalar, 3> error
            ({
                marchingError(n, s.nDims, 1, s.distance).mean,
                marchingError(n, s.nDims, 2, s.distance).mean,
                reinitialisationError
                (
                    n, s.nDims, 2, s.distance
                ).mean
            });
            std::printf("%-10s %5d", s.name, n);
            forAll(error, i)
            {
                std::printf
                (
                    "  %9.3e %6.2f",
                    error[i],
                    coarse[i] > 0 ? convergenceOrder(coarse[i], error[i]) : 0
                );
            }
            std::printf("\n");
            coarse = error;
        }
    }
}


void reinitialiseTable()
{
    std::printf
    (
        "\nEllipse from a function that is no distance, [-5, 5]^2\n"
        "%5s %11s %11s %17s %17s\n",
        "n", "mean, all", "mean, zero", "moved/h, once", "moved/h, 10 times"
    );
    for (const label n : {64, 128, 256})
    {
        const scalar h = 10.0/n;
        const reinitialisationErrors once(ellipseError(n, 1));
        const reinitialisationErrors tenTimes(ellipseError(n, 10));
        std::printf
        (
            "%5d %11.3e %11.3e %17.2e %17.2e\n",
            n,
            once.all.mean,
            once.interface.mean,
            once.motion/h,
            tenTimes.motion/h
        );
    }
}


void extensionTable()
{
    std::printf
    (
        "\nExtension of sin(2 theta) from a circle: mean error, and mean of"
        " |grad phi . grad F| in |phi| < 0.2\n"
        "%5s %11s %11s %11s %11s\n",
        "n", "error, 1", "error, 2", "product, 1", "product, 2"
    );
    for (const label n : {32, 64, 128, 256, 512})
    {
        const extensionErrors one(extensionError(n, 1));
        const extensionErrors two(extensionError(n, 2));
        std::printf
        (
            "%5d %11.3e %11.3e %11.4f %11.4f\n",
            n,
            one.value.mean,
            two.value.mean,
            one.orthogonality.mean,
            two.orthogonality.mean
        );
    }
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
