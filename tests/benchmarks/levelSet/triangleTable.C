// SPDX-License-Identifier: GPL-3.0-or-later

#include "levelSetTables.H"
#include "alignmentCases.H"

#include <cstdio>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Cells between spheres
static const label gap = 6;

//- Spheres of one diameter, in cells, as a cube, each cut from an octahedron
struct spheres
{
    scalar diameter;
    label nPerSide;
    label nCuts;
};


//- Their surfaces, none of them on the lattice
static surfaceSet cubeOf(const spheres& s, const scalar h)
{
    surfaceSet surfaces(3);
    const label n = s.nPerSide;
    for (label i = 0; i < n*n*n; ++i)
    {
        const vector place(i % n, i/n % n, i/(n*n));
        const point centre
        (
            (gap + 0.5*s.diameter)*h*vector::one
          + (s.diameter + gap)*h*place + h*vector(0.31, 0.13, 0.23)
        );
        appendSphere(surfaces, centre, 0.5*s.diameter*h, s.nCuts);
    }
    return surfaces;
}


void triangleTable()
{
    std::printf
    (
        "\nCost of one step, rebuild of 3 h at centres and corners, spheres of"
        " triangles\n"
        "%8s %8s %8s %10s %14s\n",
        "D/h", "spheres", "faces", "edge/h", "us per face"
    );
    for
    (
        const spheres& s
      : {
            spheres({8, 1, 2}),
            spheres({8, 1, 3}),
            spheres({12, 1, 3}),
            spheres({16, 1, 3}),
            spheres({16, 1, 4}),
            spheres({8, 4, 3})
        }
    )
    {
        const label n = s.nPerSide*label(s.diameter + gap) + gap;
        const scalar h = 1.0/n;
        const surfaceSet surfaces(cubeOf(s, h));

        const cartesianBlock centres(cellCentres(vector::zero, 1, n, 3, 1));
        const cartesianBlock corners
        (
            point::zero, h, label(n + 1)*labelVector::one, 3
        );
        surfaceDistance atCentres(3*h), atCorners(3*h);
        scalar rebuild = GREAT;
        for (label repeat = 0; repeat < 10; ++repeat)
        {
            const scalar start = processorTime();
            atCentres.update(surfaces, centres);
            atCorners.update(surfaces, corners);
            rebuild = min(rebuild, processorTime() - start);
        }
        const label nFaces = surfaces.faces().size();
        const scalar area = surfaces.surfaceArea(0)*surfaces.size()/nFaces;
        std::printf
        (
            "%8g %8d %8d %10.2f %14.2f\n",
            s.diameter,
            surfaces.size(),
            nFaces,
            Foam::sqrt(4*area/Foam::sqrt(3.0))/h,
            1e6*rebuild/nFaces
        );
        std::fflush(stdout);
    }
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
