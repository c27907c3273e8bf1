// SPDX-License-Identifier: GPL-3.0-or-later

#include "sparseResponse.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::sparseResponse::sparseResponse(const bodyGroup& group)
:
    viscousResponse(group)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::sparseResponse::makeModes()
{
    const Eigen::MatrixXd& r = group_.response().rotationModes();
    const scalarField& masses = group_.shape().nodeMasses();
    const Eigen::Map<const Eigen::VectorXd> mass
    (
        masses.cdata(),
        masses.size()
    );

    modes_[0] = mass.asDiagonal()*r;
    modes_[1] = multiply(r);
    added_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const scalar stiffness = project(r, copyi, 2)[1];
        added_[copyi] << stiffness + 1, -1, -1, 0;
    }
}


void Foam::fsi::sparseResponse::factorCopy
(
    const label copyi,
    const std::vector<copyLink>& links
)
{
    // A/dt + W: the nodes of a surface face are joined by springs, so that W
    // has the pattern of A
    const label nNodes = group_.shape().nNodes();
    sparseMatrix B(group_.response().matrix().matrix(copyi)/deltaT_);
    for (const copyLink& link : links)
    {
        const label n = link.nNodes();
        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < n; ++j)
            {
                for (label first = 0; first < B.rows(); first += nNodes)
                {
                    B.coeffRef(first + link.nodes[i], first + link.nodes[j]) +=
                        link.coefficient*link.weights[i]*link.weights[j];
                }
            }
        }
    }

    // The pattern changes with the triangles of the filling
    factors_[copyi] = std::make_unique<cholesky>(B);
    if (factors_[copyi]->info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "The matrix of the viscous links of copy " << copyi
            << " of shape " << group_.shape().name()
            << " is not positive definite"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::sparseResponse::makeMatrices(const std::vector<copyLink>* links)
{
    makeModes();
    factors_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        factorCopy(copyi, links[copyi]);
    }
}


void Foam::fsi::sparseResponse::solveMatrices
(
    const Eigen::MatrixXd& b,
    Eigen::MatrixXd& x
) const
{
    // The columns of a copy, one after the other
    typedef Eigen::VectorXd vectorX;
    const label nDims = group_.shape().nDims();
    const label n = nDims*b.rows();
    x.resize(b.rows(), b.cols());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        Eigen::Map<vectorX>(x.col(nDims*copyi).data(), n) =
            factors_[copyi]->solve
            (
                Eigen::Map<const vectorX>(b.col(nDims*copyi).data(), n)
            );
    }
}


// ************************************************************************* //
