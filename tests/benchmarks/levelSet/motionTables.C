// SPDX-License-Identifier: GPL-3.0-or-later

#include "levelSetTables.H"
#include "alignmentCases.H"
#include "marching/referenceFlows.H"

#include <cstdio>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

void advectionTable()
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


void alignmentTable()
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


void costTable()
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

// ************************************************************************* //
