// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmFactor.H"
#include "error.H"

#include <Eigen/SparseCholesky>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::admmFactor::store(const Eigen::SparseMatrix<double>& lower)
{
    factor_.reset(new supernodalFactor(lower));

    const label n = lower.cols();
    const label nStrict = lower.nonZeros() - n;

    columnStart_.resize(n + 1);
    columnRow_.resize(nStrict);
    rowStart_.resize(n + 1);
    rowColumn_.resize(nStrict);

    label entry = 0;
    rowStart_ = 0;
    for (label j = 0; j < n; ++j)
    {
        columnStart_[j] = entry;
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, j); it; ++it)
        {
            if (it.row() != j)
            {
                columnRow_[entry] = it.row();
                ++rowStart_[it.row() + 1];
                ++entry;
            }
        }
    }
    columnStart_[n] = entry;

    for (label i = 0; i < n; ++i)
    {
        rowStart_[i + 1] += rowStart_[i];
    }
    labelList next(rowStart_);
    for (label j = 0; j < n; ++j)
    {
        for (label e = columnStart_[j]; e < columnStart_[j + 1]; ++e)
        {
            const label place = next[columnRow_[e]]++;
            rowColumn_[place] = j;
        }
    }
}


Eigen::SparseMatrix<double> Foam::fsi::admmFactor::withoutTiny
(
    const Eigen::MatrixXd& a
) const
{
    std::vector<Eigen::Triplet<double>> kept;
    for (label j = 0; j < a.cols(); ++j)
    {
        for (label i = 0; i < a.rows(); ++i)
        {
            if (sqr(a(i, j)) > sqr(tiny)*a(i, i)*a(j, j))
            {
                kept.emplace_back(i, j, a(i, j));
            }
        }
    }

    // Nodes up to three neighbours apart stay, however weak the springs
    // between them are: others couple them besides (viscousResponse)
    typedef Eigen::SparseMatrix<double> sparseMatrix;
    const sparseMatrix next
    (
        matrix_.topLeftCorner(a.rows(), a.cols()).cwiseAbs()
    );
    const sparseMatrix near(next*next*next);
    for (label j = 0; j < near.outerSize(); ++j)
    {
        for (sparseMatrix::InnerIterator it(near, j); it; ++it)
        {
            kept.emplace_back(it.row(), j, 0);
        }
    }

    Eigen::SparseMatrix<double> result(a.rows(), a.cols());
    result.setFromTriplets(kept.begin(), kept.end());
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::admmFactor::admmFactor
(
    const Eigen::SparseMatrix<double>& matrix,
    const label nBoundary,
    const scalar deltaT
)
:
    deltaT_(deltaT),
    nBoundary_(nBoundary),
    matrix_(matrix),
    order_(matrix.rows()),
    rowOf_(matrix.rows())
{
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(matrix_);
    if (cholesky.info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "The ADMM matrix for the time step " << deltaT
            << " s is not positive definite: a density in"
            << " system/seedObjectsDict is too small, or E too large, for"
            << " numbers of 16 digits" << exit(FatalError);
    }

    for (label i = 0; i < rowOf_.size(); ++i)
    {
        rowOf_[i] = cholesky.permutationP().indices()[i];
        order_[rowOf_[i]] = i;
    }

    store(cholesky.matrixL());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Eigen::MatrixXd& Foam::fsi::admmFactor::boundaryInverse() const
{
    if (boundaryInverse_.size() == 0)
    {
        Eigen::MatrixXd columns =
            Eigen::MatrixXd::Identity(size(), nBoundary_);
        solve(columns);

        const auto block = columns.topRows(nBoundary_);
        boundaryInverse_ = 0.5*(block + block.transpose());
        sparseInverse_ = withoutTiny(boundaryInverse_);
    }
    return boundaryInverse_;
}


const Foam::fsi::admmFactor&
Foam::fsi::admmFactor::boundaryFactor() const
{
    if (!boundaryFactor_)
    {
        const Eigen::MatrixXd inverse(boundaryInverse().inverse());
        boundaryFactor_ = std::make_unique<admmFactor>
        (
            withoutTiny(0.5*(inverse + inverse.transpose())),
            nBoundary_,
            deltaT_
        );
    }
    return *boundaryFactor_;
}


// ************************************************************************* //
