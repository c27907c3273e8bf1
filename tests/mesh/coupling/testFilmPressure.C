// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "discSurfaces.H"
#include "filmPressure.H"
#include "levelSetUpdate.H"
#include "wallTreatment.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar radius = 7.1;

const point left(8.3, 10.2, 0);


//- Discs side by side in 32 x 20 cells of size 1, and the pressure x between
//  them, but for that in films
class discs
{
    boxMesh box_;
    cartesianMesh grid_;
    autoPtr<wallTreatment> wall_;
    autoPtr<levelSetUpdate> levelSet_;

public:

    interfaceGeometry geometry;
    volScalarField p;

    explicit discs(const direction split)
    :
        box_(labelVector(32, 20, 1), 2, layout(split)),
        grid_(box_.mesh()),
        wall_(wallTreatment::New(dictionary())),
        levelSet_(levelSetUpdate::New(grid_, dictionary())),
        geometry(grid_, *wall_),
        p
        (
            IOobject("p", box_.mesh().time().timeName(), box_.mesh()),
            box_.mesh(),
            dimensionedScalar(dimless, Zero)
        )
    {}

    static boxLayout layout(const direction split)
    {
        boxLayout result;
        result.splitDirection = split;
        return result;
    }

    //- Discs at these places, one step after another
    void move(const List<point>& centres)
    {
        const surfaceSet surfaces(discSurfaces(centres, radius, 96));
        levelSet_->initialise(surfaces);
        geometry.update(*levelSet_, surfaces);
    }

    //- The pressure x, 1000 in films, and what the next step starts from
    void fill()
    {
        p.primitiveFieldRef() = box_.mesh().C().primitiveField().component(0);
        for (const label celli : geometry.filmCells())
        {
            p[celli] = 1000;
        }
        p.correctBoundaryConditions();
        fillFilmCells(geometry, p);
    }

    label nFilmCells() const
    {
        return returnReduce(geometry.filmCells().size(), sumOp<label>());
    }

    scalar x(const label celli) const { return p.mesh().C()[celli].x(); }
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
    for (const label celli : slow.geometry.filmCells())
    {
        EXPECT_NEAR(slow.x(celli), between, 1.2);
        EXPECT_EQ(slow.p[celli], 1000);
    }
    slow.move({left, right});
    slow.fill();
    for (const label celli : slow.geometry.filmCells())
    {
        EXPECT_EQ(slow.geometry.filmChange()[celli], 0);
        EXPECT_EQ(slow.p[celli], 1000);
    }

    slow.move({left, right - vector(0.1, 0, 0)});
    slow.fill();
    ASSERT_GE(slow.nFilmCells(), 2);
    for (const label celli : slow.geometry.filmCells())
    {
        EXPECT_EQ(slow.geometry.filmChange()[celli], 1);
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


// ************************************************************************* //
