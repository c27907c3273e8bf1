// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "openfoamVersion.H"
#include "volFields.H"
#include "surfaceFields.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvcLaplacian.H"
#include "unitConversion.H"

using namespace Foam;
using Foam::fsi::boxLayout;
using Foam::fsi::boxMesh;

namespace
{

//- Largest sum of the area vectors of a cell's faces: 0 if all are closed
scalar openness(const fvMesh& mesh)
{
    vectorField sum(mesh.nCells(), Zero);
    const vectorField& areas = mesh.faceAreas();
    forAll(areas, facei)
    {
        sum[mesh.faceOwner()[facei]] += areas[facei];
        if (facei < mesh.nInternalFaces())
        {
            sum[mesh.faceNeighbour()[facei]] -= areas[facei];
        }
    }
    return gMax(mag(sum)());
}


//- A field cos(2 pi x/length) on a box, with the patches' natural conditions
tmp<volScalarField> wave(const fvMesh& mesh, const scalar length)
{
    auto field = fsi::newTmp<volScalarField>
    (
        IOobject("wave", fsi::nameOf(mesh.time()), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        "zeroGradient"
    );
    forAll(mesh.C(), celli)
    {
        const scalar x = mesh.C()[celli].x();
        field.ref()[celli] = Foam::cos(constant::mathematical::twoPi*x/length);
    }
    field.ref().correctBoundaryConditions();
    return field;
}


//- Largest difference of the discrete Laplacian of wave() from its exact value
//  for central differences, relative to that value
scalar laplacianError(const fvMesh& mesh, const scalar length, const scalar h)
{
    const volScalarField f(wave(mesh, length));
    const scalar eigenvalue =
        -Foam::sqr(2*Foam::sin(constant::mathematical::pi*h/length)/h);
    const volScalarField laplacian(fvc::laplacian(f));

    scalar error = 0;
    forAll(f, celli)
    {
        error = max(error, mag(laplacian[celli]/eigenvalue - f[celli]));
    }
    return returnReduce(error, maxOp<scalar>());
}

} // End namespace


TEST(boxMesh, hasTheCellsOfALattice)
{
    boxLayout layout;
    layout.origin = point(-1, 2, 0.5);
    layout.spacing = 0.25;
    boxMesh box(labelVector(6, 3, 2), 3, layout);
    const fvMesh& mesh = box.mesh();

    EXPECT_EQ(returnReduce(mesh.nCells(), sumOp<label>()), 36);
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        const label i = box.start().x() + celli % box.n().x();
        const label j = celli/box.n().x() % 3;
        const label k = celli/box.n().x()/3;
        const point centre
        (
            layout.origin + 0.25*vector(i + 0.5, j + 0.5, k + 0.5)
        );
        EXPECT_LT(mag(mesh.C()[celli] - centre), 1e-14);
        EXPECT_NEAR(mesh.V()[celli], 1.0/64, 1e-16);
    }
    EXPECT_LT(openness(mesh), 1e-14);
}


TEST(boxMesh, twoDimensionsLeaveZUnsolved)
{
    boxMesh box(labelVector(6, 4, 1), 2);
    EXPECT_EQ(box.mesh().nGeometricD(), 2);
    EXPECT_EQ(box.mesh().geometricD().z(), -1);
    EXPECT_LT(openness(box.mesh()), 1e-14);
}


TEST(boxMesh, constantFluxHasNoDivergence)
{
    boxLayout layout;
    layout.cyclic[0] = true;
    layout.cyclic[1] = true;
    boxMesh box(labelVector(8, 4, 1), 2, layout);
    const fvMesh& mesh = box.mesh();

    const surfaceScalarField flux
    (
        "flux",
        mesh.Sf() & dimensionedVector("u", dimVelocity, vector(1, 2, 0))
    );
    EXPECT_LT(gMax(mag(fvc::div(flux)().primitiveField())()), 1e-14);
}


TEST(boxMesh, wavePassesACyclicPair)
{
    for (const direction split : {0, 1})
    {
        boxLayout layout;
        layout.spacing = 0.125;
        layout.cyclic[0] = true;
        layout.splitDirection = split;
        boxMesh box(labelVector(8, 6, 1), 2, layout);
        EXPECT_LT(laplacianError(box.mesh(), 1, 0.125), 1e-12);
    }
}


TEST(boxMesh, zeroGradientWallsHoldAStandingWave)
{
    // Half a wave between walls: even about each wall, so that zero gradient
    // is exact for central differences
    boxLayout layout;
    layout.spacing = 0.125;
    boxMesh box(labelVector(8, 2, 2), 3, layout);
    EXPECT_LT(laplacianError(box.mesh(), 2, 0.125), 1e-12);
}


TEST(boxMesh, removesItsFolder)
{
    fileName path;
    {
        boxMesh box(labelVector(6, 2, 1), 2);
        path = box.casePath();
        EXPECT_TRUE(isFile(path/"system"/"fvSchemes"));
    }
    reduce(path, maxOp<fileName>());
    EXPECT_FALSE(isDir(path));
}


// ************************************************************************* //
