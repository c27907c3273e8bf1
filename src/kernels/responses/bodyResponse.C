// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyResponse.H"
#include "stepMatrix.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::bodyResponse::makeModes()
{}


void Foam::fsi::bodyResponse::addModes
(
    const modeKind kind,
    const scalar sign,
    rigidModes::modeList values
)
{
    for (Eigen::MatrixXd& each : values)
    {
        modes_.push_back({kind, sign, std::move(each)});
    }
}


void Foam::fsi::bodyResponse::respond
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    const direction nDims = shape_.nDims();
    if (matrix_)
    {
        v = force;
        matrix_->solve(v);
    }
    else
    {
        v.setZero(force.rows(), force.cols());
    }
    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        for (const mode& m : modes_)
        {
            const scalar amount =
                m.sign*rigidModes::product(m.values, force, nDims, copyi);
            v.middleCols(nDims*copyi, nDims) +=
                amount*m.values.middleCols(nDims*copyi, nDims);
        }
    }
    v *= deltaT_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyResponse::bodyResponse
(
    const shapeTemplate& shape,
    const bool hasMatrix
)
:
    hasMatrix_(hasMatrix),
    shape_(shape)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyResponse::prepare
(
    const scalar dt,
    const Eigen::MatrixXd& positions
)
{
    deltaT_ = dt;
    positions_ = positions;
    masses_ = stepMasses(shape_, dt);
    matrix_ = hasMatrix_ && nCopies() ? &shape_.factor(dt) : nullptr;
    modes_.clear();
    if (nCopies())
    {
        makeModes();
    }

    const label nB = shape_.nBoundaryNodes();
    const label nDims = shape_.nDims();
    const label nModes(modes_.size());
    boundaryModes_.resize(nB, nModes*positions.cols());
    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        for (label k = 0; k < nModes; ++k)
        {
            boundaryModes_.middleCols(nDims*(nModes*copyi + k), nDims) =
                modes_[k].values.middleCols(nDims*copyi, nDims).topRows(nB);
        }
    }
}


bool Foam::fsi::bodyResponse::preparedFor
(
    const scalar dt,
    const Eigen::MatrixXd& positions
) const
{
    return
        dt == deltaT_
     && positions.cols() == positions_.cols()
     && positions == positions_;
}


std::vector<const Foam::fsi::bodyResponse::mode*>
Foam::fsi::bodyResponse::modesOf(const modeKind kind) const
{
    std::vector<const mode*> found;
    for (const mode& m : modes_)
    {
        if (m.kind == kind)
        {
            found.push_back(&m);
        }
    }
    return found;
}


void Foam::fsi::bodyResponse::respondBoundary
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    bodyResponse::respondRoughly(force, v);
    const label nDims = shape_.nDims();
    const label nModes(modes_.size());
    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        const auto f = force.middleCols(nDims*copyi, nDims);
        for (label k = 0; k < nModes; ++k)
        {
            const auto part = boundaryModes_.middleCols
            (
                nDims*(nModes*copyi + k), nDims
            );
            scalar amount = 0;
            for (label d = 0; d < nDims; ++d)
            {
                amount += part.col(d).dot(f.col(d));
            }
            v.middleCols(nDims*copyi, nDims) += modes_[k].sign*amount*part;
        }
    }
    v *= deltaT_;
}


void Foam::fsi::bodyResponse::respondRoughly
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (!matrix_)
    {
        v.setZero(force.rows(), force.cols());
    }
    else if (shape_.nDims() == 3 && matrix_->boundaryFill() > 0.25)
    {
        // On the surface of a solid body nearly all nodes feel each other
        matrix_->solveFullBoundary(force, v);
    }
    else
    {
        matrix_->solveBoundary(force, v);
    }
}


Foam::scalar Foam::fsi::bodyResponse::roughMobility
(
    const label,
    const label nodei,
    const label
) const
{
    return matrix_ ? 1/matrix_->matrix().coeff(nodei, nodei) : 0;
}


// ************************************************************************* //
