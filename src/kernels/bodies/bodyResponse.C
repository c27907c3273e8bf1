// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyResponse.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Sum over the nodes and components of a copy
static scalar product
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b,
    const label copyi
)
{
    return
        a.col(2*copyi).dot(b.col(2*copyi))
      + a.col(2*copyi + 1).dot(b.col(2*copyi + 1));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::bodyResponse::makeRotation()
{
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape_.nodeMasses().cdata(),
        shape_.nNodes()
    );
    const scalar mass = masses.sum();

    rotation_.resize(positions_.rows(), positions_.cols());
    for (label column = 0; column < positions_.cols(); column += 2)
    {
        const scalar x = masses.dot(positions_.col(column))/mass;
        const scalar y = masses.dot(positions_.col(column + 1))/mass;
        rotation_.col(column).array() = y - positions_.col(column + 1).array();
        rotation_.col(column + 1).array() = positions_.col(column).array() - x;

        const auto block = rotation_.middleCols(column, 2);
        const scalar inertia = masses.dot(block.rowwise().squaredNorm());
        rotation_.middleCols(column, 2) /= std::sqrt(inertia);
    }
}


void Foam::fsi::bodyResponse::makeElasticRotation()
{
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape_.nodeMasses().cdata(),
        shape_.nNodes()
    );
    const Eigen::MatrixXd momenta = masses.asDiagonal()*rotation_;
    elasticRotation_ = momenta;
    matrix_->solve(elasticRotation_);

    for (label copyi = 0; copyi < positions_.cols()/2; ++copyi)
    {
        elasticRotation_.middleCols(2*copyi, 2) /=
            std::sqrt(product(elasticRotation_, momenta, copyi));
    }
}


void Foam::fsi::bodyResponse::makeVolumeMode()
{
    Eigen::MatrixXd gradient =
        Eigen::MatrixXd::Zero(positions_.rows(), positions_.cols());
    const scalar half = 0.5*shape_.thickness();

    for (label column = 0; column < positions_.cols(); column += 2)
    {
        for (const surfaceFace& face : shape_.faces())
        {
            const scalar dx =
                positions_(face[1], column) - positions_(face[0], column);
            const scalar dy =
                positions_(face[1], column + 1)
              - positions_(face[0], column + 1);
            for (label i = 0; i < 2; ++i)
            {
                gradient(face[i], column) += half*dy;
                gradient(face[i], column + 1) -= half*dx;
            }
        }
    }

    volumeMode_ = gradient;
    matrix_->solve(volumeMode_);
    volumeCompliance_.resize(positions_.cols()/2);
    for (label copyi = 0; copyi < volumeCompliance_.size(); ++copyi)
    {
        auto mode = volumeMode_.middleCols(2*copyi, 2);
        mode -= product(elasticRotation_, gradient, copyi)
           *elasticRotation_.middleCols(2*copyi, 2);
        mode += product(rotation_, gradient, copyi)
           *rotation_.middleCols(2*copyi, 2);
        volumeCompliance_[copyi] = product(volumeMode_, gradient, copyi);
    }
}


void Foam::fsi::bodyResponse::makeBoundaryModes()
{
    const label nB = shape_.nBoundaryNodes();
    boundaryModes_.resize(nB, 3*positions_.cols());

    for (label copyi = 0; copyi < positions_.cols()/2; ++copyi)
    {
        auto modes = boundaryModes_.middleCols(6*copyi, 6);
        modes.leftCols(2) =
            rotation_.middleCols(2*copyi, 2).topRows(nB);
        modes.middleCols(2, 2) =
            elasticRotation_.middleCols(2*copyi, 2).topRows(nB);
        modes.rightCols(2) =
            volumeMode_.middleCols(2*copyi, 2).topRows(nB)
           /std::sqrt(volumeCompliance_[copyi]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyResponse::bodyResponse(const shapeTemplate& shape)
:
    shape_(shape),
    matrix_(responseMatrix::New(shape))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyResponse::prepare
(
    const scalar dt,
    const Eigen::MatrixXd& positions,
    const List<List<bodyElement>>& triangles
)
{
    deltaT_ = dt;
    positions_ = positions;
    matrix_->prepare(dt, positions, triangles);

    makeRotation();
    makeElasticRotation();
    makeVolumeMode();
    makeBoundaryModes();
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


void Foam::fsi::bodyResponse::respondFreely
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    v = force;
    matrix_->solve(v);

    for (label copyi = 0; copyi < positions_.cols()/2; ++copyi)
    {
        const scalar turn = product(rotation_, force, copyi);
        const scalar elastic = product(elasticRotation_, force, copyi);

        v.middleCols(2*copyi, 2) +=
            turn*rotation_.middleCols(2*copyi, 2)
          - elastic*elasticRotation_.middleCols(2*copyi, 2);
    }
    v *= deltaT_;
}


void Foam::fsi::bodyResponse::respond
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    respondFreely(force, v);
    for (label copyi = 0; copyi < positions_.cols()/2; ++copyi)
    {
        const scalar swell =
            product(volumeMode_, force, copyi)/volumeCompliance_[copyi];
        v.middleCols(2*copyi, 2) -=
            (deltaT_*swell)*volumeMode_.middleCols(2*copyi, 2);
    }
}


void Foam::fsi::bodyResponse::respondBoundary
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    matrix_->solveBoundary(force, v);
    for (label copyi = 0; copyi < positions_.cols()/2; ++copyi)
    {
        const auto modes = boundaryModes_.middleCols(6*copyi, 6);
        for (label mode = 0; mode < 3; ++mode)
        {
            const auto part = modes.middleCols(2*mode, 2);
            const scalar amount =
                (mode == 0 ? 1 : -1)
               *(
                    part.col(0).dot(force.col(2*copyi))
                  + part.col(1).dot(force.col(2*copyi + 1))
                );
            v.middleCols(2*copyi, 2) += amount*part;
        }
    }
    v *= deltaT_;
}


// ************************************************************************* //
