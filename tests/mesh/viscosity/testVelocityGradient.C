// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "discsInBox.H"
#include "fixedValueFvPatchFields.H"
#include "openfoamVersion.H"
#include "velocityGradient.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const List<point> centres({point(15.7, 10.2, 0), point(30.6, 10.4, 0)});


//- A velocity field with given values on patches
template<class Function>
volVectorField fieldOf(const fvMesh& mesh, const Function& velocity)
{
    volVectorField U
    (
        IOobject("U", nameOf(mesh.time()), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        fixedValueFvPatchVectorField::typeName
    );
    forAll(U, celli)
    {
        U[celli] = velocity(mesh.C()[celli]);
    }
    for (fvPatchVectorField& pU : U.boundaryFieldRef())
    {
        vectorField values(pU.patch().Cf());
        for (vector& value : values)
        {
            value = velocity(value);
        }
        pU == values;
    }
    U.correctBoundaryConditions();
    return U;
}


//- Has each cell a link?
boolList linkedCells(const interfaceGeometry& geometry)
{
    boolList linked(geometry.fluidCell().size(), false);
    for (const wallLink& link : geometry.wallLinks())
    {
        linked[link.cell] = true;
    }
    return linked;
}


vector linear(const point& x)
{
    return vector(2 + 0.3*x.x() - 0.8*x.y(), 0.5*x.x() - 0.3*x.y(), 0);
}


vector parabola(const point& x)
{
    return vector(x.y()*(7 - x.y()), 0, 0);
}

} // End anonymous namespace


TEST(velocityGradient, ofALinearVelocityIsExactAwayFromWalls)
{
    for (const direction split : {0, 1})
    {
        discsInBox discs(split);
        discs.move(centres);
        const interfaceGeometry& geometry = discs.geometry();
        const volVectorField U(fieldOf(discs.mesh(), linear));
        const vectorField walls(discs.surfaces().points().size(), Zero);
        const volTensorField gradient(velocityGradient(geometry, U, walls));
        const boolList linked(linkedCells(geometry));
        const tensor exact(0.3, 0.5, 0, -0.8, -0.3, 0, 0, 0, 0);
        forAll(gradient, celli)
        {
            if (!geometry.fluidCell()[celli])
            {
                EXPECT_EQ(mag(gradient[celli]), 0);
            }
            else if (!linked[celli])
            {
                EXPECT_LT(mag(gradient[celli] - exact), 1e-11);
            }
        }
        EXPECT_NEAR(shearRate(exact), Foam::sqrt(0.45), 1e-12);
    }
}


TEST(velocityGradient, ofAUniformVelocityIsNil)
{
    discsInBox discs(0);
    discs.move(centres);
    const vector speed(1, -2, 0);
    volVectorField U
    (
        fieldOf(discs.mesh(), [&](const point&) { return speed; })
    );
    const boolList& fluid = discs.geometry().fluidCell();
    forAll(U, celli)
    {
        // Values inside objects must not be used
        U[celli] = fluid[celli] ? speed : vector(1e6, celli, 0);
    }
    U.correctBoundaryConditions();
    const vectorField walls(discs.surfaces().points().size(), speed);
    const volTensorField gradient
    (
        velocityGradient(discs.geometry(), U, walls)
    );
    forAll(gradient, celli)
    {
        EXPECT_LT(mag(gradient[celli]), 1e-13);
    }
    for (const wallLink& link : discs.geometry().wallLinks())
    {
        const tensor atWall
        (
            gradientAtWall
            (
                discs.geometry(), link, gradient[link.cell], U[link.cell],
                walls
            )
        );
        EXPECT_LT(mag(atWall), 1e-13);
    }
}


TEST(velocityGradient, ofAParabolaIsExactBesidePatches)
{
    discsInBox discs(0);
    discs.move(List<point>());
    const volVectorField U(fieldOf(discs.mesh(), parabola));
    const volTensorField gradient
    (
        velocityGradient(discs.geometry(), U, vectorField())
    );
    const vectorField& C = discs.mesh().C();
    forAll(gradient, celli)
    {
        EXPECT_NEAR(gradient[celli].yx(), 7 - 2*C[celli].y(), 1e-10);
        EXPECT_NEAR(gradient[celli].xx(), 0, 1e-10);
    }
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        if (pU.coupled())
        {
            // These have no normal gradient
            continue;
        }
        const vectorField normals(pU.patch().nf());
        const vectorField slope(pU.snGrad());
        forAll(pU, i)
        {
            const tensor& g = gradient.boundaryField()[patchi][i];
            EXPECT_LT(mag((normals[i] & g) - slope[i]), 1e-10);
        }
    }
}


// ************************************************************************* //
