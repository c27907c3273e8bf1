// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousResponse.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::viscousResponse::viscousResponse(const bodyGroup& group)
:
    group_(group),
    deltaT_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::viscousResponse::dot
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b,
    const label copyi
) const
{
    const label nDims = group_.shape().nDims();
    return a.middleCols(nDims*copyi, nDims).cwiseProduct
    (
        b.middleCols(nDims*copyi, nDims)
    ).sum();
}


void Foam::fsi::viscousResponse::solveCopy
(
    const label copyi,
    const Eigen::MatrixXd& b,
    Eigen::MatrixXd& x
) const
{
    const label nDims = group_.shape().nDims();
    if (group_.response().matrix().coupled())
    {
        // The columns of a copy, one after the other
        const label n = nDims*b.rows();
        typedef Eigen::VectorXd vectorX;
        Eigen::Map<vectorX>(x.col(nDims*copyi).data(), n) =
            factors_[copyi]->solve
            (
                Eigen::Map<const vectorX>(b.col(nDims*copyi).data(), n)
            );
    }
    else
    {
        x.middleCols(nDims*copyi, nDims) =
            factors_[copyi]->solve(b.middleCols(nDims*copyi, nDims));
    }
}


void Foam::fsi::viscousResponse::makeModes(const scalar viscosity)
{
    const label nDims = group_.shape().nDims();
    const Eigen::MatrixXd& r = group_.response().rotationModes();
    const scalarField& masses = group_.shape().nodeMasses();
    const Eigen::Map<const Eigen::VectorXd> mass
    (
        masses.cdata(),
        masses.size()
    );

    massMode_ = mass.asDiagonal()*r;
    stiffMode_ = group_.response().matrix().multiply(r);
    modeStiffness_.resize(r.cols()/nDims);
    turnDamping_.resize(r.cols()/nDims);
    for (label copyi = 0; copyi < modeStiffness_.size(); ++copyi)
    {
        modeStiffness_[copyi] = dot(r, stiffMode_, copyi);

        // r has the size arm/sqrt(I)
        const vector arm =
            point
            (
                group_.positions()(0, nDims*copyi),
                group_.positions()(0, nDims*copyi + 1),
                0
            )
          - group_.centroid(copyi);
        const scalar inertia =
            (sqr(arm.x()) + sqr(arm.y()))
           /r.block(0, nDims*copyi, 1, nDims).squaredNorm();
        turnDamping_[copyi] = 2*viscosity*group_.volume(copyi)/inertia;
    }
}


void Foam::fsi::viscousResponse::factorCopy
(
    const label copyi,
    const std::vector<copyLink>& links
)
{
    const responseMatrix& A = group_.response().matrix();
    const label nNodes = group_.shape().nNodes();

    // A/dt + W: the nodes of a surface face are joined by springs, so that W
    // has the pattern of A
    sparseMatrix B(A.matrix(copyi)/deltaT_);
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

    // The pattern of a membrane's matrix changes with its triangles
    const bool newPattern = A.coupled() || !factors_[copyi];
    if (!factors_[copyi])
    {
        factors_[copyi] = std::make_unique<cholesky>();
    }
    if (newPattern)
    {
        factors_[copyi]->analyzePattern(B);
    }
    factors_[copyi]->factorize(B);
    if (factors_[copyi]->info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "The matrix of the viscous links of copy " << copyi
            << " of shape " << group_.shape().name()
            << " is not positive definite"
            << exit(FatalError);
    }

    solveCopy(copyi, massMode_, solvedMassMode_);
    solveCopy(copyi, stiffMode_, solvedStiffMode_);

    // K - A = U S U^T, U = [m s], S = [a+1, -1; -1, 0], a = r^T A r, so that
    // S^-1 = -[0, 1; 1, a+1]; the damping b adds dt b to a
    Eigen::Matrix2d W;
    W << dot(massMode_, solvedMassMode_, copyi),
         dot(massMode_, solvedStiffMode_, copyi) - deltaT_,
         dot(stiffMode_, solvedMassMode_, copyi) - deltaT_,
         dot(stiffMode_, solvedStiffMode_, copyi)
       - deltaT_*(modeStiffness_[copyi] + 1 + deltaT_*turnDamping_[copyi]);
    woodbury_[copyi] = W.inverse();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousResponse::update
(
    const scalar dt,
    const scalar viscosity,
    const std::vector<std::vector<copyLink>>& links,
    const Eigen::MatrixXd& predicted
)
{
    const label nDims = group_.shape().nDims();
    const label nCopies = group_.size();
    deltaT_ = dt;

    makeModes(viscosity);
    factors_.resize(nCopies);
    woodbury_.resize(nCopies);
    solvedMassMode_.resize(massMode_.rows(), massMode_.cols());
    solvedStiffMode_.resize(massMode_.rows(), massMode_.cols());
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        factorCopy(copyi, links[copyi]);
    }

    // K v~ = A v~ - m (s.v~) - s (m.v~) + (a + 1) m (m.v~)
    source_ = group_.response().matrix().multiply(predicted);
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        const scalar mv = dot(massMode_, predicted, copyi);
        const scalar sv = dot(stiffMode_, predicted, copyi);
        const scalar turn = dot(massMode_, group_.velocities(), copyi);
        source_.middleCols(nDims*copyi, nDims) +=
            (
                (modeStiffness_[copyi] + 1)*mv - sv
              + dt*turnDamping_[copyi]*turn
            )
           *massMode_.middleCols(nDims*copyi, nDims)
          - mv*stiffMode_.middleCols(nDims*copyi, nDims);
    }
    source_ /= dt;
}


void Foam::fsi::viscousResponse::solve
(
    Eigen::MatrixXd& f,
    Eigen::MatrixXd& v,
    const bool withSource
) const
{
    const label nDims = group_.shape().nDims();
    if (withSource)
    {
        f += source_;
    }

    v.resize(f.rows(), f.cols());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        solveCopy(copyi, f, v);
        auto vc = v.middleCols(nDims*copyi, nDims);

        const Eigen::Vector2d projected
        (
            dot(massMode_, v, copyi),
            dot(stiffMode_, v, copyi)
        );
        const Eigen::Vector2d c(woodbury_[copyi]*projected);
        vc -= c[0]*solvedMassMode_.middleCols(nDims*copyi, nDims);
        vc -= c[1]*solvedStiffMode_.middleCols(nDims*copyi, nDims);
    }
}


// ************************************************************************* //
