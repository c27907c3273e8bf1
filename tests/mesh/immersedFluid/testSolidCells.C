// SPDX-License-Identifier: GPL-3.0-or-later

// Cells inside objects in the momentum equation and in the gradient of the
// pressure are compared with the plain way to have them, cell by cell

#include <gtest/gtest.h>

#include "discsInBox.H"
#include "immersedGradient.H"
#include "immersedMomentum.H"
#include "openfoamMesh.H"
#include "zeroGradientFvPatchFields.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Some number for a place, between -1 and 1
scalar some(const label i)
{
    return std::sin(0.7 + 3.1*i);
}


void setSome(scalarField& values, const label first)
{
    forAll(values, i)
    {
        values[i] = some(first + i);
    }
}


void setSome(vectorField& values, const label first)
{
    forAll(values, i)
    {
        values[i] = vector(some(first + i), some(5 + i), some(2*i));
    }
}


template<class FieldType>
FieldType someField(const fvMesh& mesh)
{
    FieldType field
    (
        IOobject("some", nameOf(mesh.time()), mesh),
        mesh,
        dimensioned<typename FieldType::value_type>(dimless, Zero),
        word("zeroGradient")
    );
    setSome(field.primitiveFieldRef(), 1);
    field.correctBoundaryConditions();
    return field;
}


//- Discs side by side, which leave cells between them with two walls
List<point> places()
{
    return {point(15.7, 10.2, 0), point(30.6, 10.4, 0)};
}


void expectEqual(const fvVectorMatrix& a, const fvVectorMatrix& b)
{
    EXPECT_EQ(a.diag(), b.diag());
    EXPECT_EQ(a.upper(), b.upper());
    EXPECT_EQ(a.lower(), b.lower());
    EXPECT_EQ(a.source(), b.source());
    forAll(internalCoeffsOf(a), patchi)
    {
        EXPECT_EQ(internalCoeffsOf(a)[patchi], internalCoeffsOf(b)[patchi]);
        EXPECT_EQ(boundaryCoeffsOf(a)[patchi], boundaryCoeffsOf(b)[patchi]);
    }
}


//- Gradient of a cell, false if it is at a patch, whose faces are left out
bool plainGradient
(
    const interfaceGeometry& geometry,
    const scalarField& p,
    const label celli,
    vector& gradient
)
{
    const fvMesh& mesh = geometry.grid().mesh();
    vector sum(Zero), weights(SMALL, SMALL, SMALL);
    label nInternal = 0;
    for (const label facei : mesh.cells()[celli])
    {
        if (facei < mesh.nInternalFaces())
        {
            const scalar w = geometry.openness()[facei];
            const direction d = geometry.grid().faceDirection(facei);
            const label own = mesh.faceOwner()[facei];
            const label nei = mesh.faceNeighbour()[facei];
            const scalar step = mesh.C()[nei][d] - mesh.C()[own][d];
            sum[d] += w*(p[nei] - p[own])/step;
            weights[d] += w;
            ++nInternal;
        }
    }
    gradient = cmptDivide(sum, weights);
    return nInternal == 2*geometry.grid().nDims();
}

} // End anonymous namespace


TEST(solidCells, leaveTheMomentumEquationAsBySetValues)
{
    for (direction split = 0; split < 2; ++split)
    {
        discsInBox discs(split);
        discs.move(places());
        volVectorField U(someField<volVectorField>(discs.mesh()));
        fvVectorMatrix equation(U, dimless);
        setSome(equation.diag(), 2);
        setSome(equation.upper(), 3);
        setSome(equation.lower(), 4);
        setSome(equation.source(), 5);
        forAll(internalCoeffsOf(equation), patchi)
        {
            setSome(internalCoeffsOf(equation)[patchi], 6);
            setSome(boundaryCoeffsOf(equation)[patchi], 7);
        }
        fvVectorMatrix plain(equation);
        DynamicList<label> solid;
        forAll(U, celli)
        {
            if (!discs.geometry().fluidCell()[celli])
            {
                solid.append(celli);
            }
        }
        plain.setValues(solid, vectorField(U.primitiveField(), solid));

        const timeRule rule(equation.psi().mesh());
        immersedMomentum(discs.geometry(), rule).constrain(equation);
        expectEqual(equation, plain);
        EXPECT_GT(returnReduce(solid.size(), sumOp<label>()), 100);
    }
}


TEST(solidCells, haveTheMeanGradientOfTheirFluidNeighbours)
{
    discsInBox discs(0);
    discs.move(places());
    const interfaceGeometry& geometry = discs.geometry();
    const volScalarField p(someField<volScalarField>(discs.mesh()));
    const immersedGradient fluid(geometry);
    const volVectorField open(fluid.openGradient(p));
    const volVectorField extended(fluid.gradient(p));
    forAll(p, celli)
    {
        vector here(Zero);
        if (!plainGradient(geometry, p, celli, here))
        {
            continue;
        }
        EXPECT_LT(mag(open[celli] - here), 1e-12) << "cell " << celli;

        const bool isFluid = geometry.fluidCell()[celli];
        vector mean(isFluid ? open[celli] : vector(Zero));
        scalar n = 0;
        for (const label other : discs.mesh().cellCells()[celli])
        {
            if (!isFluid && geometry.fluidCell()[other])
            {
                mean += open[other];
                ++n;
            }
        }
        mean /= max(n, scalar(1));
        EXPECT_LT(mag(extended[celli] - mean), 1e-12) << "cell " << celli;
    }
}


// ************************************************************************* //
