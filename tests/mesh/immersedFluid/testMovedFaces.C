// SPDX-License-Identifier: GPL-3.0-or-later

// Faces near surfaces keep their velocity when these move

#include <gtest/gtest.h>

#include "atFace.H"
#include "discSurfaces.H"
#include "movedFaces.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"
#include "surfacesInBox.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar radius = 3;

//- Velocity of the fluid
const vector wind(1, 2, 0);


//- Two discs in a row in a fluid of one velocity
struct pairInWind
{
    surfacesInBox discs;
    const faceVelocities faces;
    movedFaces moved;
    const volVectorField U;
    surfaceScalarField history;

    explicit pairInWind(const direction split)
    :
        discs(labelVector(40, 20, 1), 2, split),
        faces(discs.geometry()),
        moved(discs.geometry(), faces),
        U
        (
            IOobject("U", nameOf(discs.mesh().time()), discs.mesh()),
            discs.mesh(),
            dimensionedVector("wind", dimVelocity, wind),
            word("zeroGradient")
        ),
        history
        (
            IOobject("history", nameOf(discs.mesh().time()), discs.mesh()),
            discs.mesh(),
            dimensionedScalar(dimVelocity, Zero)
        )
    {}

    //- Set the discs at their first places
    void place(const scalar x0, const scalar x1)
    {
        const List<point> centres({point(x0, 10, 0), point(x1, 10, 0)});
        discs.move(discSurfaces(centres, radius, 60));
    }

    //- Move the discs, whose surfaces have one velocity
    void move(const scalar x0, const scalar x1, const vector& walls)
    {
        const vectorField nodal(discs.surfaces().points().size(), walls);
        moved.begin(U, nodal);
        place(x0, x1);
        moved.end(U, nodal, 0, 0, history);
    }
};

} // End anonymous namespace


TEST(movedFaces, haveNothingToKeepInAUniformFlow)
{
    for (const direction split : {0, 1})
    {
        pairInWind p(split);
        p.place(14, 21);
        p.move(14.1, 21, wind);

        // The film is forgotten while no surface is near
        p.move(8, 31, wind);
        p.move(8.1, 31, wind);
        p.move(12.5, 31, wind);
        p.move(14, 21, wind);
        p.move(14, 21.1, wind);
        // Ranks have different numbers of patches
        scalar largest = 0;
        for (const scalar jump : p.history.primitiveField())
        {
            largest = max(largest, mag(jump));
        }
        for (const scalarField& onPatch : p.history.boundaryField())
        {
            for (const scalar jump : onPatch)
            {
                largest = max(largest, mag(jump));
            }
        }
        EXPECT_LT(overRanks(largest, maxOp<scalar>()), 1e-12);
    }
}


TEST(movedFaces, keepTheVelocityOfTheFluidInAFilmThatWasNotNear)
{
    for (const direction split : {0, 1})
    {
        pairInWind p(split);
        p.place(8, 31);
        const scalarField before(p.discs.levelSet().cellDistance());
        p.move(14, 21, Zero);
        label n = 0;
        for (const filmFace& film : p.discs.geometry().films().faces())
        {
            const cartesianMesh& grid = p.discs.grid();
            const label own = p.discs.mesh().faceOwner()[film.face];
            if (before[grid.haloIndex()[own]] > 2.5)
            {
                ++n;
                const scalar along = wind[film.dir];
                EXPECT_NEAR
                (
                    atFace(p.history, film.face),
                    grid.faceAlong(film.face) ? along : -along,
                    1e-12
                );
            }
        }
        EXPECT_GT(overRanks(n, sumOp<label>()), 3);
    }
}


TEST(movedFaces, keepTheVelocityOfAFilmThatEndedFarFromSurfaces)
{
    for (const direction split : {0, 1})
    {
        pairInWind p(split);
        p.place(14, 21);
        const List<filmFace> films(p.discs.geometry().films().faces());
        p.move(8, 31, Zero);
        const cartesianMesh& grid = p.discs.grid();
        const scalarField& after = p.discs.levelSet().cellDistance();
        label n = 0;
        for (const filmFace& film : films)
        {
            const label here =
                grid.haloIndex()[p.discs.mesh().faceOwner()[film.face]];
            const label there = here + grid.stepAcross(film.face);
            if (min(after[here], after[there]) > 2.5)
            {
                ++n;
                const scalar along = wind[film.dir];
                EXPECT_NEAR
                (
                    atFace(p.history, film.face),
                    grid.faceAlong(film.face) ? -along : along,
                    1e-12
                );
            }
        }
        EXPECT_GT(overRanks(n, sumOp<label>()), 3);
    }
}


// ************************************************************************* //
