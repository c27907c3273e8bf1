// SPDX-License-Identifier: GPL-3.0-or-later

#include "wormLikeMembrane.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "triangleForces.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(wormLikeMembrane, 0);
    addToRunTimeSelectionTable(membraneLaw, wormLikeMembrane, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

//- Energy of a triangle for the modulus 1
struct networkEnergy
{
    //- x_0
    static constexpr double rest = 1/2.2;

    static constexpr double perFree = 1/(1 - rest);

    //- F(x_0)
    static constexpr double restForce = 0.25*perFree*perFree - 0.25 + rest;

    //- a of an edge: 4 over the square root of 3, over the sum that the shear
    //  modulus of the network has
    static constexpr double strength =
        4/1.7320508075688772
       /(
            0.5*rest*perFree*perFree*perFree - 0.25*perFree*perFree + 0.25
          + 3*restForce
        );

    //- k/G_s
    const double ofTriangles;

    //- Half of an edge, which has another triangle besides: add its energy, and
    //  return twice the derivative by g, the square of its length. G: the
    //  square at rest
    template<class Array>
    [[gnu::always_inline]]
    static inline Array edge(const Array& g, const double G, Array& E)
    {
        const Array stretch((g*Array(1/G)).sqrt());
        const Array x(Array(rest)*stretch);
        // As good as infinite at the largest length, and beyond
        const Array perLeft(Array(1)/(Array(1) - x).max(Array(1e-100)));
        const Array perStretch(Array(1)/stretch);
        const Array squares(x*x);
        E +=
            Array(0.5*strength*G)
           *(
                Array(0.25/rest)*squares*(Array(3) - x - x)*perLeft
              + Array(restForce)*perStretch
            );
        return
            Array(0.5*strength)*perStretch
           *(
                Array(0.25)*perLeft*perLeft - Array(0.25) + x
              - Array(restForce)*perStretch*perStretch
            );
    }

    template<class Array>
    [[gnu::always_inline]]
    inline void set
    (
        const membraneTriangle& t,
        const sidesMetric<Array>& g,
        Array& E,
        sidesMetric<Array>& s
    ) const
    {
        // G_ij from its inverse
        const double det = 1/t.perDeterminant;
        const double G11 = t.inverse[2]*det, G22 = t.inverse[0]*det;
        const double G12 = -t.inverse[1]*det;

        // Area, and its square's derivatives
        const Array area
        (
            Array(0.5)*(g.of11*g.of22 - g.of12*g.of12).sqrt()
        );
        const Array strain(area*Array(1/t.area) - Array(1));
        E = Array(0.5*ofTriangles*t.area)*strain*strain;
        const Array ofArea(Array(0.25*ofTriangles)*strain/area);

        const Array h1(edge(g.of11, G11, E));
        const Array h2(edge(g.of22, G22, E));
        const Array h3
        (
            edge(g.of11 + g.of22 - g.of12 - g.of12, G11 + G22 - 2*G12, E)
        );
        s.of11 = h1 + h3 + ofArea*g.of22;
        s.of12 = -h3 - ofArea*g.of12;
        s.of22 = h2 + h3 + ofArea*g.of11;
    }
};

} // End anonymous namespace


FSI_AVX2_CLONES
static void addNetworkForces
(
    const scalar ofTriangles,
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
)
{
    addTriangleForces<laneArray<membraneLaw::nLanes>>
    (
        networkEnergy{ofTriangles}, triangles, x, force, energy
    );
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::wormLikeMembrane::wormLikeMembrane(const dictionary& dict)
:
    membraneLaw
    (
        readPositive(dict, "shearModulus"),
        readAreaModulus(dict, 2),
        {"shearModulus", "areaModulus"}
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wormLikeMembrane::addForces
(
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
) const
{
    addNetworkForces(areaModulus() - 2, triangles, x, force, energy);
}


// ************************************************************************* //
