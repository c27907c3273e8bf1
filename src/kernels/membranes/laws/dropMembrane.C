// SPDX-License-Identifier: GPL-3.0-or-later

#include "dropMembrane.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "triangleForces.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(dropMembrane, 0);
    addToRunTimeSelectionTable(membraneLaw, dropMembrane, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

struct dropEnergy
{
    template<class Array>
    [[gnu::always_inline]]
    inline void set
    (
        const Array& I1, const Array& I2, Array& W, Array& W1, Array& W2
    ) const
    {
        W = (I2 + Array(1)).sqrt();
        W1 = Array(0);
        W2 = Array(0.5)/W;
    }
};

} // End anonymous namespace


FSI_AVX2_CLONES
static void addDropForces
(
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
)
{
    addTriangleForces<laneArray<membraneLaw::nLanes>>
    (
        ofInvariants<dropEnergy>(), triangles, x, force, energy
    );
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::dropMembrane::dropMembrane(const dictionary& dict)
:
    membraneLaw(readPositive(dict, "tension"), 1, {"tension"})
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::dropMembrane::addForces
(
    const UList<membraneTriangle>& triangles,
    const double* x,
    double* force,
    double* energy
) const
{
    addDropForces(triangles, x, force, energy);
}


// ************************************************************************* //
