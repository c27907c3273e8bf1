// SPDX-License-Identifier: GPL-3.0-or-later

#include "SkalakMembrane.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "triangleForces.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(SkalakMembrane, 0);
    addToRunTimeSelectionTable(membraneLaw, SkalakMembrane, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

struct SkalakEnergy
{
    const double C;

    template<class Array>
    [[gnu::always_inline]]
    inline void set
    (
        const Array& I1, const Array& I2, Array& W, Array& W1, Array& W2
    ) const
    {
        const Array ofArea(Array(C)*I2);
        W = Array(0.25)*(I1*(I1 + Array(2)) + I2*(ofArea - Array(2)));
        W1 = Array(0.5)*(I1 + Array(1));
        W2 = Array(0.5)*(ofArea - Array(1));
    }
};

} // End anonymous namespace


FSI_AVX2_CLONES
static void addSkalakForces
(
    const scalar ratio,
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
)
{
    addTriangleForces<laneArray<membraneLaw::nLanes>>
    (
        ofInvariants<SkalakEnergy>{{ratio}}, triangles, x, force, energy
    );
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::SkalakMembrane::SkalakMembrane(const dictionary& dict)
:
    membraneLaw
    (
        readPositive(dict, "shearModulus"),
        readAreaModulus(dict, 1),
        {"shearModulus", "areaModulus"}
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::SkalakMembrane::addForces
(
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
) const
{
    addSkalakForces(ofSkalak(), triangles, x, force, energy);
}


// ************************************************************************* //
