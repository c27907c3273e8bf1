// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "cartesianMesh.H"
#include "colouredMatrix.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Velocities on a box whose walls move with (1 2 0)
volVectorField velocity(const fvMesh& mesh)
{
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector("U", dimVelocity, vector(1, 2, 0)),
        "fixedValue"
    );
    U.primitiveFieldRef() = Zero;
    U.correctBoundaryConditions();
    return U;
}


//- A source that changes from cell to cell
vectorField roughSource(const fvMesh& mesh)
{
    vectorField source(mesh.nCells());
    forAll(source, celli)
    {
        const scalar x = mesh.C()[celli].x();
        const scalar y = mesh.C()[celli].y();
        source[celli] = vector(Foam::sin(3*x + y), Foam::cos(2*y), 0);
    }
    return source;
}


//- Viscous momentum equation with a source besides the walls'
tmp<fvVectorMatrix> momentum(volVectorField& U, const vectorField& source)
{
    tmp<fvVectorMatrix> tequation
    (
        fvm::Sp(dimensionedScalar("rate", dimless/dimTime, 0.7), U)
      - fvm::laplacian(dimensionedScalar("nu", dimViscosity, 1.3), U)
    );
    tequation.ref().source() += source;
    return tequation;
}


//- Expect what OpenFOAM's solver gives
void expectSolution(const volVectorField& U, const vectorField& source)
{
    volVectorField expected(velocity(U.mesh()));
    dictionary controls;
    controls.add("solver", "PCG");
    controls.add("preconditioner", "DIC");
    controls.add("tolerance", 1e-12);
    momentum(expected, source)->solve(controls);
    EXPECT_LT(gMax(mag(U - expected)().primitiveField()), 1e-9);
}

} // End anonymous namespace


TEST(colouredMatrix, solvesAndRespondsToAnotherSource)
{
    for (const direction split : {0, 1})
    {
        boxLayout layout;
        layout.splitDirection = split;
        boxMesh box(labelVector(12, 8, 1), 2, layout);
        const cartesianMesh grid(box.mesh());
        const vectorField none(box.mesh().nCells(), Zero);
        const vectorField source(roughSource(box.mesh()));

        volVectorField U(velocity(box.mesh()));
        const tmp<fvVectorMatrix> equation(momentum(U, none));
        colouredMatrix matrix(grid);
        matrix.set(equation());
        const auto sweep = [&]()
        {
            for (label i = 0; i < 200; ++i)
            {
                matrix.sweep(1.3);
            }
        };
        sweep();
        matrix.get(U.primitiveFieldRef());
        expectSolution(U, none);

        const vectorField before(U.primitiveField());
        matrix.restart(source);
        matrix.addTo(U.primitiveFieldRef());
        EXPECT_EQ(U.primitiveField(), before);
        sweep();
        matrix.addTo(U.primitiveFieldRef());
        expectSolution(U, source);
    }
}


// ************************************************************************* //
