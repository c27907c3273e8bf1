// SPDX-License-Identifier: GPL-3.0-or-later

#include "passAcceleration.H"
#include "sumOverRanks.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Change f = b - d x of an iteration; each rank holds other values
scalarField change(const scalarField& x, const scalarField& d)
{
    scalarField f(x.size());
    forAll(f, i)
    {
        f[i] = 1 + 0.1*i - d[i]*x[i];
    }
    return f;
}


//- Largest |f| of all ranks after some passes from zero
scalar remains(const label nPasses, const label depth, const scalarList& values)
{
    scalarField d(24);
    forAll(d, i)
    {
        d[i] = values[(i + Pstream::myProcNo()) % values.size()];
    }
    passAcceleration acceleration(depth);
    scalarField x(d.size(), Zero);
    for (label pass = 0; pass < nPasses; ++pass)
    {
        x = acceleration.next(x, change(x, d));
    }
    return gMax(mag(change(x, d)));
}

} // End anonymous namespace


TEST(passAcceleration, endsWhereEachValueWasSeen)
{
    // The bare iteration diverges for values above 2 and is slow near 0
    const scalarList values({0.01, 0.3, 1, 3, 20});

    EXPECT_GT(remains(4, 10, values), 1e-3);
    // To the square root of the threshold below which differences are dropped
    EXPECT_LT(remains(6, 20, values), 1e-5);
}


TEST(passAcceleration, givesWhatIsBesideAValueTheSameWay)
{
    // A vector that is linear in x stays so
    const scalarField d({0.1, 0.7, 2.5});
    passAcceleration acceleration(2);
    scalarField x(d.size(), Zero);
    for (label pass = 0; pass < 4; ++pass)
    {
        const scalarField f(change(x, d));
        const scalarField found(x + f);
        x = acceleration.next(x, f);
        const vectorField beside
        (
            acceleration.beside(vectorField(1, vector(found[0], found[2], 1)))
        );
        EXPECT_NEAR(beside[0].x(), x[0], 1e-10);
        EXPECT_NEAR(beside[0].y(), x[2], 1e-10);
        EXPECT_NEAR(beside[0].z(), 1, 1e-12);
    }
}


TEST(passAcceleration, withoutMemoryIsTheBareIteration)
{
    // f falls by 1 - 0.5 in each pass
    EXPECT_NEAR
    (
        remains(5, 0, {0.5})/remains(0, 0, {0.5}), 1/32.0, 1e-12
    );
}


TEST(passAcceleration, standsPassesThatRepeat)
{
    // A start and a change that come again tell nothing new
    passAcceleration acceleration(5);
    const scalarField x(4, 1.0);
    const scalarField f(4, 0.5);
    acceleration.next(x, f);
    EXPECT_LT(max(mag(acceleration.next(x, f) - (x + f))), 1e-12);
}


// ************************************************************************* //
