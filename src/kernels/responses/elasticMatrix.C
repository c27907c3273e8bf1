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
    // On the surface of a solid body nearly all nodes feel each other
    if (shape_.nDims() == 3 && factor_->boundaryFill() > 0.25)
    {
        factor_->solveFullBoundary(f, v);
    }
    else
    {
        factor_->solveBoundary(f, v);
    }
}


// ************************************************************************* //
