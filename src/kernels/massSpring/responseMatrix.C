// SPDX-License-Identifier: GPL-3.0-or-later

#include "responseMatrix.H"
#include "elasticMatrix.H"
#include "membraneMatrix.H"

// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::responseMatrix> Foam::fsi::responseMatrix::New
(
    const shapeTemplate& shape
)
{
    if (shape.membrane())
    {
        return autoPtr<responseMatrix>(new membraneMatrix(shape));
    }
    return autoPtr<responseMatrix>(new elasticMatrix(shape));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Eigen::MatrixXd Foam::fsi::responseMatrix::multiply
(
    const Eigen::MatrixXd& x
) const
{
    Eigen::MatrixXd result(x.rows(), x.cols());
    for (label copyi = 0; copyi < x.cols()/2; ++copyi)
    {
        if (coupled())
        {
            // Both columns of a copy lie one after the other
            Eigen::Map<Eigen::VectorXd>
            (
                result.col(2*copyi).data(),
                2*x.rows()
            ) = matrix(copyi)*Eigen::Map<const Eigen::VectorXd>
            (
                x.col(2*copyi).data(),
                2*x.rows()
            );
        }
        else
        {
            result.middleCols(2*copyi, 2) =
                matrix(copyi)*x.middleCols(2*copyi, 2);
        }
    }
    return result;
}


Foam::scalar Foam::fsi::responseMatrix::diagonal
(
    const label copyi,
    const label nodei,
    const label component
) const
{
    const sparseMatrix& A = matrix(copyi);
    const label i = nodei + (coupled() ? component*A.rows()/2 : 0);
    return A.coeff(i, i);
}


// ************************************************************************* //
