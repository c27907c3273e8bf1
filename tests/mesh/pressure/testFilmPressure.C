// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "discsInBox.H"
#include "filmPressure.H"
#include "immersedGradient.H"
#include "openfoamVersion.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar radius = discsInBox::radius;

const point left(8.3, 10.2, 0);


//- Discs side by side, and the pressure x between them, but for that in films
class discs
:
    public discsInBox
{
public:

    volScalarField p;

    explicit discs(const direction split)
    :
        discsInBox(split),
        p
        (
            IOobject("p", nameOf(mesh().time()), mesh()),
            mesh(),
            dimensionedScalar(dimless, Zero)
        )
    {}

    //- The pressure x, 1000 in films, and what the next step starts from
    void fill()
    {
        p.primitiveFieldRef() = mesh().C().primitiveField().component(0);
        for (const label celli : geometry().filmCells())
        {
            p[celli] = 1000;
        }
        p.correctBoundaryConditions();
        fillFilmCells(geometry(), p);
    }

    label nFilmCells() const
    {
        return returnReduce(geometry().filmCells().size(), sumOp<label>());
    }

    scalar x(const label celli) const { return mesh().C()[celli].x(); }
};


//- Expect that a film that changes by nothing, or fast, is filled or not
void expectFilled(const direction split)
{
    const point right(left + vector(2*radius + 0.3, 0.4, 0));
    const scalar between = left.x() + radius + 0.15;

    discs slow(split);
    slow.move({left, right});
    ASSERT_GE(slow.nFilmCells(), 2);
    slow.fill();
    for (const label celli : slow.geometry().filmCells())
    {
        EXPECT_NEAR(slow.x(celli), between, 1.2);
        EXPECT_EQ(slow.p[celli], 1000);
    }
    slow.move({left, right});
    slow.fill();
    for (const label celli : slow.geometry().filmCells())
    {
        EXPECT_EQ(slow.geometry().filmChange()[celli], 0);
        EXPECT_EQ(slow.p[celli], 1000);
    }

    slow.move({left, right - vector(0.1, 0, 0)});
    slow.fill();
    ASSERT_GE(slow.nFilmCells(), 2);
    for (const label celli : slow.geometry().filmCells())
    {
        EXPECT_EQ(slow.geometry().filmChange()[celli], 1);
        EXPECT_NEAR(slow.p[celli], between, 2);
    }
}

} // End anonymous namespace


TEST(FilmPressure, oneSurfaceIsNoFilm)
{
    discs one(0);
    for (const scalar shift : {0.0, 0.1, 0.35, 0.5, 0.77})
    {
        one.move({left + vector(5 + shift, 0.6*shift, 0)});
        EXPECT_EQ(one.nFilmCells(), 0) << shift;
    }
}


TEST(FilmPressure, filmsThatChangeStartFromTheirNeighbours)
{
    expectFilled(0);
    expectFilled(1);
}


TEST(FilmPressure, wallsHoldTheFluid)
{
    const scalar rAU = 0.7;
    const scalar viscosity = 0.4;
    for (const direction split : {0, 1})
    {
        // The gradient of the pressure falls to a third in the step
        discs pair(split);
        pair.move({left, left + vector(2*radius + 0.3, 0.4, 0)});
        ASSERT_GE(pair.nFilmCells(), 2);
        pair.p.primitiveFieldRef() = pair.mesh().C().component(1);
        pair.p.correctBoundaryConditions();
        volVectorField U
        (
            IOobject("U", nameOf(pair.mesh().time()), pair.mesh()),
            pair.mesh(),
            dimensionedVector(dimless, Zero)
        );
        const immersedGradient fluid(pair.geometry());
        const volVectorField gradient(fluid.gradient(pair.p));
        fluid.correctVelocity(U, 3*gradient, pair.p, rAU, viscosity);

        // Cells of unit size: a link's friction is one over its distance
        scalarField friction(pair.mesh().nCells(), Zero);
        for (const wallLink& link : pair.geometry().wallLinks())
        {
            friction[link.cell] += viscosity/link.wallDistance;
        }
        forAll(U, celli)
        {
            const scalar step = rAU/(1 + rAU*friction[celli]);
            EXPECT_LT
            (
                mag(U[celli] - 2*step*gradient[celli]),
                1e-12*(1 + mag(gradient[celli]))
            );
        }
        EXPECT_GT(returnReduce(max(friction), maxOp<scalar>()), viscosity);
    }
}


// ************************************************************************* //
