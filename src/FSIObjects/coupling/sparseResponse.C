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
    modes_[1] = group_.response().matrix().multiply(r);
    added_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const scalar stiffness = product(r, modes_[1], copyi);
        added_[copyi] << stiffness + 1, -1, -1, 0;
    }
}


void Foam::fsi::sparseResponse::solveCopy
(
    const label copyi,
    const Eigen::MatrixXd& b,
    Eigen::MatrixXd& x
) const
{
    // The columns of a copy, one after the other
    const label nDims = group_.shape().nDims();
    const label n = nDims*b.rows();
    typedef Eigen::VectorXd vectorX;
    Eigen::Map<vectorX>(x.col(nDims*copyi).data(), n) =
        factors_[copyi]->solve
        (
            Eigen::Map<const vectorX>(b.col(nDims*copyi).data(), n)
        );
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
        for (label i = 0; i < 3 && link.nodes[i] >= 0; ++i)
        {
            for (label j = 0; j < 3 && link.nodes[j] >= 0; ++j)
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

void Foam::fsi::sparseResponse::prepare(const copyLinks& links)
{
    const label nDims = group_.shape().nDims();
    const label nCopies = group_.size();
    makeModes();
    factors_.resize(nCopies);
    woodbury_.resize(nCopies);
    for (label mode = 0; mode < 2; ++mode)
    {
        solved_[mode].resize(modes_[mode].rows(), modes_[mode].cols());
    }

    source_ = group_.response().matrix().multiply(start_);
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        factorCopy(copyi, links[copyi]);
        solveCopy(copyi, modes_[0], solved_[0]);
        solveCopy(copyi, modes_[1], solved_[1]);

        Eigen::Matrix2d inverse(deltaT_*added_[copyi].inverse());
        inverse.col(0) += project(solved_[0], copyi);
        inverse.col(1) += project(solved_[1], copyi);
        woodbury_[copyi] = inverse.inverse();

        const Eigen::Vector2d amount(added_[copyi]*project(start_, copyi));
        for (label mode = 0; mode < 2; ++mode)
        {
            source_.middleCols(nDims*copyi, nDims) +=
                amount[mode]*modes_[mode].middleCols(nDims*copyi, nDims);
        }
    }
    source_ /= deltaT_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::sparseResponse::solve
(
    Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    const label nDims = group_.shape().nDims();
    Eigen::MatrixXd b(source_);
    b.topRows(f.rows()) += f;
    Eigen::MatrixXd x(b.rows(), b.cols());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        solveCopy(copyi, b, x);
        const Eigen::Vector2d amount(woodbury_[copyi]*project(x, copyi));
        for (label mode = 0; mode < 2; ++mode)
        {
            x.middleCols(nDims*copyi, nDims) -=
                amount[mode]*solved_[mode].middleCols(nDims*copyi, nDims);
        }
    }
    v = x.topRows(f.rows());
}


// ************************************************************************* //
