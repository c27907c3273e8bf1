// SPDX-License-Identifier: GPL-3.0-or-later

// Conjugate gradients of cartesianMultigrid with a term beside the matrix, as
// the coupling uses them

#include <gtest/gtest.h>
#include "multigridCases.H"
#include "openfoamMesh.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Square objects of 6 x 6 cells in fields of 16 x 16 that each resist their
//  compression, K = -sum over objects of stiffness g g^T, whichever ranks
//  their cells are on. The matrix is negative, and so is K
class squares
:
    public addedTerm
{
    const List<labelVector>& cells_;
    label nRow_;
    scalar stiffness_;
    bool named_;
    DynamicList<label> inside_;

    //- Share of a cell in its object, 0 outside
    scalar share(const label celli) const
    {
        const labelVector& c = cells_[celli];
        return (c.x() % 16 < 6 && c.y() % 16 < 6) ? 1 : 0;
    }

    label object(const label celli) const
    {
        const labelVector& c = cells_[celli];
        return c.x()/16 + nRow_*(c.y()/16);
    }

public:

    //- named: tell which cells the objects cover, and take values of these
    //  only
    squares(const latticeMesh& mesh, label nRow, scalar stiffness, bool named)
    :
        cells_(mesh.cells()),
        nRow_(nRow),
        stiffness_(stiffness),
        named_(named)
    {
        forAll(cells_, celli)
        {
            if (share(celli) > 0)
            {
                inside_.append(celli);
            }
        }
    }

    const labelUList* cells() const override
    {
        return named_ ? &inside_ : nullptr;
    }

    //- The row sums of K
    scalarField diagonal() const
    {
        scalarField ones(cells_.size(), 1);
        scalarField result(cells_.size(), Zero);
        addToAll(result, ones);
        return result;
    }

    void add(scalarField& Ax, const scalarField& x) const override
    {
        if (!named_)
        {
            addToAll(Ax, x);
            return;
        }
        ASSERT_EQ(x.size(), inside_.size());
        scalarField all(cells_.size(), Zero);
        scalarField result(cells_.size(), Zero);
        forAll(inside_, i)
        {
            all[inside_[i]] = x[i];
        }
        addToAll(result, all);
        forAll(inside_, i)
        {
            Ax[i] += result[inside_[i]];
        }
    }

    //- Ax += K x for values of all cells
    void addToAll(scalarField& Ax, const scalarField& x) const
    {
        scalarField total(nRow_*nRow_, Zero);
        forAll(cells_, celli)
        {
            total[object(celli)] += share(celli)*x[celli];
        }
        Pstream::listCombineGather(total, plusEqOp<scalar>());
        Pstream::listCombineScatter(total);
        forAll(cells_, celli)
        {
            Ax[celli] -= stiffness_*share(celli)*total[object(celli)];
        }
    }
};


//- Slabs of a lattice of 32 cells along x, with a step of a cell each
label steppedSlabs(const labelVector& c)
{
    const label width = 32/Pstream::nProcs();
    const label place = c.y() < 7 ? c.x() - 1 : c.x();
    return min(max(place, 0)/width, Pstream::nProcs() - 1);
}

} // End namespace


TEST(cartesianLattice, takesSteppedBoxes)
{
    if (Pstream::parRun())
    {
        latticeOptions options(box(32, 32));
        options.rank = steppedSlabs;
        latticeMesh mesh(options);
        const cartesianLattice lattice(mesh.mesh());

        // A cut may leave the step on either side of it
        EXPECT_FALSE(lattice.transfer().local());
        EXPECT_LE(lattice.transfer().nElsewhere(), 25);
        const label me = Pstream::myProcNo();
        const label width = 32/Pstream::nProcs();
        const bool last = me == Pstream::nProcs() - 1;
        EXPECT_NEAR
        (
            lattice.layout().n().x(), last ? 32 - me*width : width, 1
        );
        EXPECT_NEAR(lattice.layout().start().x(), me*width, 1);
        EXPECT_EQ(lattice.layout().n().y(), 32);
    }
}


TEST(cartesianMultigrid, solvesWithATerm)
{
    latticeOptions options(box(32, 32));

    // Ranks' boxes, such with steps in their sides, and cells scattered over
    // the ranks
    for (const label kind : {0, 1, 2})
    {
        if (kind == 1)
        {
            options.rank = steppedSlabs;
        }
        if (kind == 2)
        {
            options.shuffled = true;
            options.rank = [](const labelVector& c)
            {
                return (c.x()/5 + c.y()/7) % Pstream::nProcs();
            };
        }
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {});
        tmp<fvScalarMatrix> eqn(problem.completeEquation());

        for (const label i : {0, 1, 2, 3})
        {
            // b = (A + K) x for a known x
            const scalar stiffness = i < 2 ? 0.01 : 1.0;
            const squares term(mesh, 2, stiffness, i % 2);
            const scalarField& exact = problem.exact();
            scalarField b(exact.size());
            eqn().Amul
            (
                b, exact, boundaryCoeffsOf(eqn()), problem.interfaces(), 0
            );
            term.addToAll(b, exact);

            cartesianMultigrid::loopControls controls;
            controls.tolerance = 1e-11;
            cartesianMultigrid multigrid(mesh.mesh(), smallGather());
            multigrid.update
            (
                eqn(), boundaryCoeffsOf(eqn()), problem.interfaces(),
                term.diagonal()
            );
            scalarField x(exact.size(), Zero);
            const solverPerformance result =
                multigrid.solve(x, b, "p", controls, &term);
            EXPECT_TRUE(result.converged()) << stiffness;
            EXPECT_LT(difference(x, exact), 1e-7) << stiffness;
        }
    }
}


TEST(cartesianMultigrid, addedDiagonalHelps)
{
    latticeMesh mesh(box(64, 64));
    poissonProblem problem(mesh, {});
    tmp<fvScalarMatrix> eqn(problem.completeEquation());
    const scalarField b(randomField(mesh, 4));

    // A term that is its own diagonal
    struct holdsCells : public addedTerm
    {
        scalarField diagonal;

        void add(scalarField& Ax, const scalarField& x) const override
        {
            Ax += diagonal*x;
        }
    } term;
    term.diagonal = -3*pos(randomField(mesh, 3) - 0.7);

    label count[2];
    for (label added = 0; added < 2; ++added)
    {
        cartesianMultigrid multigrid(mesh.mesh(), smallGather());
        multigrid.update
        (
            eqn(), boundaryCoeffsOf(eqn()), problem.interfaces(),
            added ? term.diagonal : scalarField()
        );
        scalarField x(b.size(), Zero);
        cartesianMultigrid::loopControls controls;
        controls.tolerance = 1e-10;
        const solverPerformance result =
            multigrid.solve(x, b, "p", controls, &term);
        EXPECT_TRUE(result.converged());
        count[added] = result.nIterations();
    }
    EXPECT_LE(count[1], 16);
    EXPECT_LT(2*count[1], count[0]);
}


// ************************************************************************* //
