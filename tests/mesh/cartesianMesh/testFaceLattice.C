// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "faceLattice.H"
#include "sumOverRanks.H"

#include <random>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar spacing = 0.5;


//- 12 x 8 x 6 cells, cyclic along x, with walls
boxLayout layout()
{
    boxLayout result;
    result.origin = point(1, -2, 0.5);
    result.spacing = spacing;
    result.cyclic[0] = true;
    return result;
}


//- Shear flow along x
vector flowAt(const point& x)
{
    return vector(3 + 2*x.y() - x.z(), 0, 0);
}


//- The flow in cells and at walls, whose velocity is given
tmp<volVectorField> flow(const fvMesh& mesh)
{
    wordList types(mesh.boundary().size(), "fixedValue");
    forAll(types, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            types[patchi] = mesh.boundary()[patchi].type();
        }
    }
    tmp<volVectorField> tU
    (
        new volVectorField
        (
            IOobject("U", "0", mesh, IOobject::NO_READ, IOobject::NO_WRITE),
            mesh,
            dimensionedVector("U", dimVelocity, Zero),
            types
        )
    );
    volVectorField& U = tU.ref();
    forAll(U, celli)
    {
        U[celli] = flowAt(mesh.C()[celli]);
    }
    forAll(U.boundaryField(), patchi)
    {
        fvPatchVectorField& pU = U.boundaryFieldRef()[patchi];
        vectorField values(pU.size());
        forAll(values, i)
        {
            values[i] = flowAt(pU.patch().Cf()[i]);
        }
        pU == values;
    }
    return tU;
}


tmp<surfaceScalarField> faceField
(
    const fvMesh& mesh,
    const dimensionSet& dimensions,
    const scalar value
)
{
    return tmp<surfaceScalarField>
    (
        new surfaceScalarField
        (
            IOobject("f", "0", mesh, IOobject::NO_READ, IOobject::NO_WRITE),
            mesh,
            dimensionedScalar("f", dimensions, value)
        )
    );
}


tmp<surfaceScalarField> fluxOf(const fvMesh& mesh)
{
    tmp<surfaceScalarField> tphi
    (
        faceField(mesh, dimVelocity*dimArea, 0)
    );
    surfaceScalarField& phi = tphi.ref();
    forAll(phi, facei)
    {
        phi[facei] = flowAt(mesh.Cf()[facei]) & mesh.Sf()[facei];
    }
    forAll(phi.boundaryField(), patchi)
    {
        fvsPatchScalarField& pf = phi.boundaryFieldRef()[patchi];
        forAll(pf, i)
        {
            pf[i] = flowAt(pf.patch().Cf()[i]) & pf.patch().Sf()[i];
        }
    }
    return tphi;
}


//- Places in the box and beside its walls, the same on all ranks
pointField places(const scalar wallDistance)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<scalar> in(0, 1);
    pointField result(60);
    for (point& p : result)
    {
        p = layout().origin
          + vector
            (
                6*in(random),
                wallDistance + (4 - 2*wallDistance)*in(random),
                1.1 + 0.8*in(random)
            );
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(faceLattice, interpolatesAShearFlowUpToWalls)
{
    boxMesh box(labelVector(12, 8, 6), 3, layout());
    const cartesianMesh grid(box.mesh());
    const faceLattice faces(grid);
    faceLattice::faceArrays u;
    faces.setVelocities
    (
        fluxOf(box.mesh()),
        faceField(box.mesh(), dimless, 1),
        flow(box.mesh()),
        u
    );
    const pointField x(places(0.01*spacing));
    for (const label width : {2, 3, 4})
    {
        vectorField v(x.size());
        staggeredTransfer(faces.lattice(), width).interpolate(x, u, v);
        sumOverRanks(v);
        forAll(v, i)
        {
            EXPECT_NEAR(mag(v[i] - flowAt(x[i])), 0, 1e-12)
                << "with " << width << " points at " << x[i].x() << ' '
                << x[i].y() << ' ' << x[i].z();
        }
    }
}


TEST(faceLattice, closedFacesHaveTheVelocityOfTheirCells)
{
    boxMesh box(labelVector(12, 8, 6), 3, layout());
    const cartesianMesh grid(box.mesh());
    const faceLattice faces(grid);
    faceLattice::faceArrays u;
    faces.setVelocities
    (
        faceField(box.mesh(), dimVelocity*dimArea, 0),
        faceField(box.mesh(), dimless, 0),
        flow(box.mesh()),
        u
    );
    const pointField x(places(2*spacing));
    vectorField v(x.size());
    staggeredTransfer(faces.lattice(), 3).interpolate(x, u, v);
    sumOverRanks(v);
    forAll(v, i)
    {
        EXPECT_NEAR(mag(v[i] - flowAt(x[i])), 0, 1e-12);
    }
}


TEST(faceLattice, cellsGetTheSumOfTheForcesAndTheirMoments)
{
    boxMesh box(labelVector(12, 8, 6), 3, layout());
    const cartesianMesh grid(box.mesh());
    const faceLattice faces(grid);
    const pointField x(places(2*spacing));
    vectorField force(x.size());
    std::mt19937 random(2);
    std::uniform_real_distribution<scalar> in(-1, 1);
    for (vector& f : force)
    {
        f = vector(in(random), in(random), in(random));
    }
    faceLattice::faceArrays values;
    faces.setZero(values);
    staggeredTransfer(faces.lattice(), 4).spread(x, force, values);
    vectorField cells;
    faces.setCells(flow(box.mesh()), values, cells);

    // Moments of y and z, along which the box is not cyclic
    List<vector> sums(3, Zero);
    forAll(cells, celli)
    {
        sums[0] += cells[celli];
        sums[1] += box.mesh().C()[celli].y()*cells[celli];
        sums[2] += box.mesh().C()[celli].z()*cells[celli];
    }
    sumOverRanks(sums);
    forAll(x, i)
    {
        sums[0] -= force[i];
        sums[1] -= x[i].y()*force[i];
        sums[2] -= x[i].z()*force[i];
    }
    for (const vector& difference : sums)
    {
        EXPECT_NEAR(mag(difference), 0, 1e-11);
    }
}


// ************************************************************************* //
