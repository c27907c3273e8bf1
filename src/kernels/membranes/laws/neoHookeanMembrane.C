// SPDX-License-Identifier: GPL-3.0-or-later

#include "neoHookeanMembrane.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "triangleForces.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(neoHookeanMembrane, 0);
    addToRunTimeSelectionTable(membraneLaw, neoHookeanMembrane, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

struct neoHookeanEnergy
{
    template<class Array>
    [[gnu::always_inline]]
    inline void set
    (
        const Array& I1, const Array& I2, Array& W, Array& W1, Array& W2
    ) const
    {
        const Array perSquare(Array(1)/(I2 + Array(1)));
        W = Array(0.5)*(I1 - Array(1) + perSquare);
        W1 = Array(0.5);
        W2 = Array(-0.5)*perSquare*perSquare;
    }
};

} // End anonymous namespace


FSI_AVX2_CLONES
static void addNeoHookeanForces
(
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
)
{
    addTriangleForces<laneArray<membraneLaw::nLanes>>
    (
        ofInvariants<neoHookeanEnergy>(), triangles, x, force, energy
    );
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::neoHookeanMembrane::neoHookeanMembrane(const dictionary& dict)
:
    membraneLaw(readPositive(dict, "shearModulus"), 3, {"shearModulus"})
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::neoHookeanMembrane::addForces
(
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
) const
{
    addNeoHookeanForces(triangles, x, force, energy);
}


// ************************************************************************* //
