// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Work of an elastic body's iteration on sparse matrices: solutions with
    a factor in blocks, and forces of shear.

\*---------------------------------------------------------------------------*/

#include "samples/samples.H"
#include "shearMatrix.H"
#include "shearTerm.H"
#include "samples/solidMeshes.H"
#include "supernodalFactor.H"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The Laplacian of a mesh's elements and a mass
Eigen::SparseMatrix<double> stepMatrixOf(const shapeMesh& mesh)
{
    const strainDomains domains(mesh, 1, strainDomains::kind::element);
    matrixEntries entries;
    domains.addLaplacian(1, entries);
    const label n = mesh.points.size();
    for (label i = 0; i < n; ++i)
    {
        entries.emplace_back(i, i, 0.1 + 0.01*i);
    }
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}


//- Forces of shear over mu from the elements' own deformation gradients
template<int nDims>
Eigen::MatrixXd elementForces
(
    const strainDomains& domains,
    const Eigen::MatrixXd& u,
    const bool shear
)
{
    Eigen::MatrixXd force(Eigen::MatrixXd::Zero(u.rows(), nDims));
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        scalar P[nDims*nDims];
        domains.gradient(domaini, u, false, P);
        if (shear)
        {
            shearTerm::toGradient<nDims>(P);
        }
        for (scalar& p : P)
        {
            p *=
                (shear ? shearTerm::bound(nDims) : 1)
               *domains.volumes()[domaini];
        }
        domains.addForce(domaini, P, force);
    }
    return force;
}


//- Forces by the matrix, its rows in reverse
template<int nDims, bool shear>
Eigen::MatrixXd matrixForces
(
    const strainDomains& domains,
    const Eigen::MatrixXd& u
)
{
    const label n(u.rows());
    labelList rowOf(n);
    forAll(rowOf, node)
    {
        rowOf[node] = n - 1 - node;
    }
    const shearMatrix matrix(domains, rowOf);
    Eigen::MatrixXd force(n, nDims);
    for (label row = 0; row < matrix.size(); ++row)
    {
        scalar f[nDims];
        matrix.force<nDims, shear>
        (
            row,
            [&](const label i, const label k) { return u(n - 1 - i, k); },
            f
        );
        for (int k = 0; k < nDims; ++k)
        {
            force(n - 1 - row, k) = f[k];
        }
    }
    return force;
}


template<int nDims>
void compareForces(const shapeMesh& mesh)
{
    Eigen::MatrixXd u(mesh.points.size(), nDims);
    for (label i = 0; i < u.size(); ++i)
    {
        u.data()[i] = std::sin(7.0*i);
    }
    const Eigen::MatrixXd still
    (
        Eigen::MatrixXd::Constant(u.rows(), nDims, 0.3)
    );
    for
    (
        const auto kind :
        {
            strainDomains::kind::element,
            strainDomains::kind::edge,
            strainDomains::kind::node
        }
    )
    {
        const strainDomains domains(mesh, 1, kind);
        const Eigen::MatrixXd shear(elementForces<nDims>(domains, u, true));
        const Eigen::MatrixXd all(elementForces<nDims>(domains, u, false));
        EXPECT_GT(shear.norm(), 0.1*all.norm());
        EXPECT_LT
        (
            (matrixForces<nDims, true>(domains, u) - shear).norm(),
            1e-13*shear.norm()
        );
        EXPECT_LT
        (
            (matrixForces<nDims, false>(domains, u) - all).norm(),
            1e-13*all.norm()
        );
        EXPECT_EQ((matrixForces<nDims, true>(domains, still)).norm(), 0);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sparseKernels, shearIsTheSumOfTheElements)
{
    compareForces<2>(samples::latticeBar(6, 4, 0.1));
    compareForces<3>(solidSamples::box(4, 3, 3, 0.1));
}


TEST(sparseKernels, blocksSolveForAnyWidth)
{
    for
    (
        const shapeMesh& mesh :
        {samples::latticeBar(20, 8, 0.1), solidSamples::box(6, 5, 7, 0.1)}
    )
    {
        const Eigen::SparseMatrix<double> A(stepMatrixOf(mesh));
        const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(A);
        const Eigen::SparseMatrix<double> L(cholesky.matrixL());
        const Eigen::SparseMatrix<double> permuted(L*L.transpose());
        const supernodalFactor factor(L);
        const label n(A.rows());
        for (const label width : {2, 3, 4, 6, 8, 12, 16, 24})
        {
            typedef Eigen::Matrix
            <
                double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor
            > rows;
            rows x(n, width);
            for (label i = 0; i < x.size(); ++i)
            {
                x.data()[i] = std::cos(3.0*i);
            }
            const rows b(permuted*x);
            rows solved(b);
            factor.solveRows(width, solved.data());
            EXPECT_LT((solved - x).norm(), 1e-12*x.norm()) << width;

            // A column is the same whatever stands beside it
            rows two(b.leftCols(2));
            factor.solveRows(2, two.data());
            EXPECT_EQ((two - solved.leftCols(2)).norm(), 0) << width;
        }
    }
}


// ************************************************************************* //
