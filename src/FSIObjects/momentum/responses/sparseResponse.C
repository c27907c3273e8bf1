// SPDX-License-Identifier: GPL-3.0-or-later

#include "sparseResponse.H"
#include "blockMatrix.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::sparseResponse::sparseResponse(const bodyGroup& group)
:
    woodburyResponse(group)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::sparseResponse::factorCopy
(
    const label copyi,
    const std::vector<copyLink>& links
)
{
    const blockMatrix& A = *group_.response().matrix()->ownMatrix(copyi);
    const blockPattern& pattern = A.pattern();

    scalarField values(A.values()/deltaT_);
    for (const copyLink& link : links)
    {
        for (label i = 0; i < link.nNodes(); ++i)
        {
            for (label j = 0; j < link.nNodes(); ++j)
            {
                const scalar value =
                    link.coefficient*link.weights[i]*link.weights[j];
                const label nodeA = link.nodes[i], nodeB = link.nodes[j];
                const label at = pattern.valueOf(nodeA, nodeB);
                if (at >= 0)
                {
                    values[at] += value;
                    values[at + 3] += value;
                }
            }
        }
    }
    if (!factors_[copyi].factor(pattern, values))
    {
        FatalErrorInFunction
            << "The matrix of the viscous links of copy " << copyi
            << " of shape " << group_.shape().name()
            << " is not positive definite"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::sparseResponse::makeModes()
{
    const Eigen::MatrixXd& r =
        group_.response().modesOf(bodyResponse::modeKind::rotation)[0]->values;
    const scalarField& masses = group_.shape().nodeMasses();
    const Eigen::Map<const Eigen::VectorXd> mass
    (
        masses.cdata(),
        masses.size()
    );

    modes_.resize(2);
    modes_[0] = mass.asDiagonal()*r;
    modes_[1] = multiply(r);
    added_.assign(group_.size(), modeMatrix(2, 2));
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const scalar stiffness = project(modes_, r, copyi, 2)[1];
        added_[copyi] << stiffness + 1, -1, -1, 0;
    }
}


void Foam::fsi::sparseResponse::makeMatrices
(
    const std::vector<copyLink>* links,
    std::vector<Eigen::MatrixXd>& x
)
{
    factors_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        factorCopy(copyi, links[copyi]);
    }
    solveMatrices(x);
}


void Foam::fsi::sparseResponse::solveMatrices
(
    const Eigen::MatrixXd& b,
    Eigen::MatrixXd& x
) const
{
    // The columns of a copy lie one after the other
    x = b;
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        factors_[copyi].solve(x.col(group_.shape().nDims()*copyi).data());
    }
}


// ************************************************************************* //
