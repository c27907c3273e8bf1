// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Program
    levelSetTables

Description
    Prints the measured figures of the level set in doc/theory.md: errors and
    orders of the march, of the extension and of the advection, alignment and
    cost of the rebuilt and the advected level set. Takes some minutes.

Usage
    levelSetTables [march|reinitialise|extension|advection|alignment|cost]...

    Without an argument all tables are printed.
\*---------------------------------------------------------------------------*/

#include "alignmentCases.H"
#include "reinitialisationCases.H"
#include "referenceFlows.H"

#include <cstdio>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static void marchTable()
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
                    n, s.nDims, 2, "cubic", s.distance
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


static void reinitialiseTable()
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


static void extensionTable()
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


static void advectionTable()
{
    std::printf("\nSmooth wave carried on: mean error and order\n");
    scalar coarse = 0;
    for (const label n : {16, 32, 64, 128})
    {
        const scalar error = waveError(n, 2).mean;
        std::printf
        (
            "%5d %11.3e %6.2f\n",
            n,
            error,
            coarse > 0 ? convergenceOrder(coarse, error) : 0
        );
        coarse = error;
    }

    std::printf
    (
        "\nArea change in per cent, and mismatch over h\n"
        "%-16s %5s %20s %20s %20s\n",
        "case", "n", "no reinitialisation", "band 6 h, every 5",
        "band 6 h, each step"
    );
    const auto row = [](const char* name, const label n, const scalar h,
        const std::function<advectionErrors(const bandTreatment&)>& run)
    {
        std::printf("%-16s %5d", name, n);
        for (const label interval : {0, 5, 1})
        {
            bandTreatment band;
            band.bandWidth = interval ? 6 : 0;
            band.interval = interval;
            const advectionErrors errors(run(band));
            std::printf
            (
                " %11.3f %8.3f", 100*errors.area, errors.mismatch/h
            );
            std::fflush(stdout);
        }
        std::printf("\n");
    };
    for (const label n : {50, 100, 200})
    {
        row("Zalesak", n, 100.0/n, [=](const bandTreatment& band)
        {
            return zalesakError(n, band);
        });
    }
    for (const label period : {2, 8})
    {
        for (const label n : {64, 128, 256})
        {
            row(period == 2 ? "vortex, T = 2" : "vortex, T = 8", n, 1.0/n,
                [=](const bandTreatment& band)
                {
                    return vortexError(n, period, band);
                });
        }
    }
}


static void alignmentTable()
{
    std::printf
    (
        "\nFour discs of radius 0.3/2 turned once, stretched by exp(+-0.3)"
        " twice and carried round\n"
        "%-10s %5s %6s %12s %12s %9s %9s %12s\n",
        "way", "n", "steps", "misfit/h max", "mean", "area %", "rebuilds",
        "ms per step"
    );
    const char* names[] = {"rebuilt", "advected", "tolerance"};
    for (const label n : {64, 128, 256})
    {
        for (const label wayi : {0, 1, 2})
        {
            deformingDiscs discs(2, 0.3, n);
            const label nSteps = 10*n;
            const alignmentResult result
            (
                follow(discs, n, nSteps, static_cast<following>(wayi))
            );
            std::printf
            (
                "%-10s %5d %6d %12.4f %12.4f %9.3f %9d %12.3f\n",
                names[wayi],
                n,
                nSteps,
                result.largest,
                result.mean,
                100*result.area,
                result.nRebuilds,
                1000*result.seconds
            );
            std::fflush(stdout);
        }
    }
}


static void costTable()
{
    std::printf
    (
        "\nCost of one call, discs of 30 nodes in a square\n"
        "%6s %6s %14s %20s %20s\n",
        "n", "discs", "rebuild 4h, ms", "march 4h, ms", "ns/(n log2 n)"
    );
    for (const label n : {160, 320, 640, 1280})
    {
        const deformingDiscs discs(n/32, 0.3, 30);
        const cartesianBlock block(cellCentres(vector::zero, 1, n, 2));
        const scalar h = block.spacing();
        surfaceDistance exact(4*h), beside(1.5*h);
        fastMarching marching(4*h);
        levelSetFields fields;

        scalar rebuild = GREAT, march = GREAT;
        for (label repeat = 0; repeat < 5; ++repeat)
        {
            const scalar start = processorTime();
            exact.update(discs.surfaces(), block);
            const scalar middle = processorTime();
            fields.start(beside, discs.surfaces(), block);
            const scalar marchStart = processorTime();
            marching.march(block, fields);
            rebuild = min(rebuild, middle - start);
            march = min(march, processorTime() - marchStart);
        }
        const scalar nBand = marching.reached().size();
        std::printf
        (
            "%6d %6d %14.2f %20.2f %20.2f\n",
            n,
            discs.surfaces().size(),
            1e3*rebuild,
            1e3*march,
            1e9*march/(nBand*std::log2(nBand))
        );
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace Foam;

    const std::vector<std::pair<std::string, void (*)()>> tables
    ({
        {"march", fsi::marchTable},
        {"reinitialise", fsi::reinitialiseTable},
        {"extension", fsi::extensionTable},
        {"advection", fsi::advectionTable},
        {"alignment", fsi::alignmentTable},
        {"cost", fsi::costTable}
    });

    for (const auto& table : tables)
    {
        bool wanted = argc == 1;
        for (int i = 1; i < argc; ++i)
        {
            wanted = wanted || table.first == argv[i];
        }
        if (wanted)
        {
            table.second();
            std::fflush(stdout);
        }
    }
    return 0;
}


// ************************************************************************* //
