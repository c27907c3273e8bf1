// SPDX-License-Identifier: GPL-3.0-or-later

#include "elasticMatrix.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::elasticMatrix::elasticMatrix(const shapeTemplate& shape)
:
    shape_(shape)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::elasticMatrix::prepare
(
    const scalar dt,
    const Eigen::MatrixXd&,
    const List<List<bodyElement>>&
)
{
    factor_ = &shape_.factor(dt);
}


void Foam::fsi::elasticMatrix::solveBoundary
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    // Panels small enough for the product to work without the heap
    const label width = 32;
    const Eigen::MatrixXd& inverse = factor_->boundaryInverse();
    const label n = f.cols();
    v.resize(inverse.rows(), n);

    for (label first = 0; first < n; first += width)
    {
        const label nColumns = min(width, n - first);
        v.middleCols(first, nColumns).noalias() =
            inverse*f.middleCols(first, nColumns);
    }
}


// ************************************************************************* //
