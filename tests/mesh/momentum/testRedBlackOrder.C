// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "cartesianMesh.H"
#include "openfoamVersion.H"
#include "redBlackMatrix.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- A box that is cyclic in both directions and has two cells per rank and
//  direction, so that each row has patches of all kinds
boxLayout periodic()
{
    boxLayout layout;
    layout.cyclic[0] = layout.cyclic[1] = true;
    return layout;
}


labelVector smallest()
{
    return labelVector(2*Pstream::nProcs(), 2, 1);
}

} // End anonymous namespace


// Single precision shows the order of a sum: neighbours are below and above in
// x, then in y, whether a face is inside, cyclic or between ranks
TEST(redBlackOrder, neighboursHaveOneOrder)
{
    boxMesh box(smallest(), 2, periodic());
    const fvMesh& mesh = box.mesh();
    const cartesianMesh grid(mesh);
    const redBlackOrder order(grid);
    ASSERT_EQ(order.nSlots(), 4);

    label nFound = 0;
    const auto expectSlot = [&]
    (
        const label celli,
        const label slot,
        const vector& outwards
    )
    {
        const direction d = mag(outwards.x()) > mag(outwards.y()) ? 0 : 1;
        EXPECT_EQ
        (
            slot, 4*order.rowOf()[celli] + 2*d + (outwards[d] > 0 ? 1 : 0)
        );
        ++nFound;
    };
    forAll(mesh.owner(), facei)
    {
        const vector S(mesh.faceAreas()[facei]);
        expectSlot(mesh.owner()[facei], order.ownerSlot()[facei], S);
        expectSlot(mesh.neighbour()[facei], order.neighbourSlot()[facei], -S);
    }
    forAll(order.patchSlot(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        forAll(order.patchSlot()[patchi], i)
        {
            expectSlot
            (
                patch.faceCells()[i], order.patchSlot()[patchi][i],
                patch.Sf()[i]
            );
        }
    }
    EXPECT_EQ(nFound, 4*mesh.nCells());
}


// Rows that only patches couple have the radius of all others
TEST(redBlackMatrix, radiusCountsAllNeighbours)
{
    boxMesh box(smallest(), 2, periodic());
    volVectorField U
    (
        IOobject("U", nameOf(box.mesh().time()), box.mesh()),
        box.mesh(),
        dimensionedVector("U", dimVelocity, Zero)
    );
    const fvVectorMatrix equation
    (
        fvm::Sp(dimensionedScalar("rate", dimless/dimTime, 1), U)
      - fvm::laplacian
        (
            dimensionedScalar("nu", sqr(dimLength)/dimTime, 1), U
        )
    );
    const cartesianMesh grid(box.mesh());
    redBlackMatrix matrix(grid);
    matrix.set(equation);
    EXPECT_NEAR(matrix.radii()[0], 4.0/(4 + 1), 1e-12);
    EXPECT_NEAR(matrix.radii()[1], 0, 1e-12);
    EXPECT_NEAR(matrix.relaxation(), 2/(1 + 0.6), 1e-12);
    EXPECT_NEAR(overRelaxation::best(1, 0.6), 2/(1 + 0.6), 1e-12);
}


// ************************************************************************* //
