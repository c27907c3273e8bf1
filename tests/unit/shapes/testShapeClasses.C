// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "IStringStream.H"
#include "scaledShape.H"
#include "shapeClasses.H"
#include "valueSpread.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

dictionary textDict(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


scalarField spread(const std::string& text, const label n)
{
    return valueSpread(textDict(text), n);
}


scalar deviation(const scalarField& values)
{
    return std::sqrt(average(sqr(values - average(values))));
}


const std::string disc
(
    "shape { type circle; radius 0.1; } material { density 1; E 10; }"
    " distribution { "
);

} // End anonymous namespace


TEST(ShapeClasses, meanAndDeviationAreExact)
{
    for (const label n : {2, 7, 40})
    {
        for (const char* type : {"normal", "logNormal"})
        {
            const scalarField values
            (
                spread
                (
                    "type " + std::string(type) + "; mean 3; deviation 0.6;", n
                )
            );
            ASSERT_EQ(values.size(), n);
            EXPECT_NEAR(average(values), 3, 1e-9) << type << n;
            EXPECT_NEAR(deviation(values), 0.6, 1e-9) << type << n;
        }
        const scalarField values(spread("type uniform; min 1; max 4;", n));
        EXPECT_NEAR(average(values), 2.5, 1e-12);
        EXPECT_NEAR(deviation(values), 3/std::sqrt(12.0), 1e-12);
    }

    // Quantiles: the median of a log-normal is below its mean
    const scalarField values
    (
        spread("type logNormal; mean 1; deviation 1;", 99)
    );
    EXPECT_NEAR(values[49], 1/std::sqrt(2.0), 0.03);
    EXPECT_GT(min(values), 0);

    const scalarField listed
    (
        spread("type list; values (5 1 3); weights (1 2 1);", 8)
    );
    EXPECT_EQ(listed, scalarField({5, 5, 1, 1, 1, 1, 3, 3}));
}


TEST(ShapeClasses, valuesAreChecked)
{
    for
    (
        const char* bad :
        {
            "type normal; mean 1; deviation 0.9;", "type even; min 1; max 2;",
            "type uniform; min 2; max 1;", "type normal; mean 1;",
            "type normal; mean 1; deviation 0.1; min 0;",
            "type list; values (1 2); weights (1);",
            "type list; values (1 -2);",
            "type logNormal; mean 1; deviation 9;"
        }
    )
    {
        EXPECT_THROW(spread(bad, 10), Foam::IOerror) << bad;
    }
}


TEST(ShapeClasses, classesHaveValuesOfTheirOwn)
{
    const shapeClasses classes
    (
        textDict
        (
            disc + "classes 20; size { type uniform; min 0.5; max 1.5; }"
            " E { type normal; mean 10; deviation 2; } }"
        )
    );
    ASSERT_EQ(classes.size(), 20);
    scalarField sizes(20), moduli(20);
    forAll(sizes, i)
    {
        const dictionary dict(classes.dictOf(i));
        EXPECT_FALSE(dict.found("distribution"));
        sizes[i] = classes.sizeOf(i);
        moduli[i] =
            dict.subDict("material").lookupOrDefault<scalar>("E", 0);
        EXPECT_EQ
        (
            dict.subDict("material").lookupOrDefault<scalar>("density", 0), 1
        );
    }
    EXPECT_NEAR(average(sizes), 1, 1e-12);
    EXPECT_NEAR(average(moduli), 10, 1e-9);
    EXPECT_NEAR(deviation(moduli), 2, 1e-9);
    const scalar together = average
    (
        (sizes - average(sizes))*(moduli - average(moduli))
    );
    EXPECT_LT(mag(together), 0.5*deviation(sizes)*deviation(moduli));

    for
    (
        const char* bad :
        {"nu { type uniform; min 1; max 2; } }", "E 3; }", "classes 0; }"}
    )
    {
        EXPECT_THROW(shapeClasses(textDict(disc + bad)), Foam::IOerror) << bad;
    }
}


TEST(ShapeClasses, scaledShapeIsTheShapeInAnotherUnit)
{
    const autoPtr<shape> circle
    (
        shape::New(textDict("type circle; radius 0.1;"), 2)
    );
    const scaledShape large(circle(), 3, 2);
    EXPECT_NEAR(large.volume(), 9*circle().volume(), 1e-12);
    EXPECT_NEAR(large.minimumThickness(), 0.6, 1e-4);
    EXPECT_NEAR(large.bounds().span().x(), 0.6, 1e-12);
    const shapeMesh mesh
    (
        large.mesh(0.06, meshGrading(dictionary()), true)
    );
    EXPECT_NEAR(sum(mesh.elementVolumes()), large.volume(), 1e-9);
}
