// SPDX-License-Identifier: GPL-3.0-or-later

#include "groupContact.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Boundary nodes of the reference shape
static pointField boundaryPoints(const shapeTemplate& shape)
{
    return pointField
    (
        SubList<point>(shape.points(), shape.nBoundaryNodes())
    );
}

//- Sum over the rows and components of each copy
static Eigen::VectorXd products
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b,
    const label nDims
)
{
    const Eigen::RowVectorXd columns = a.cwiseProduct(b).colwise().sum();
    Eigen::VectorXd sums(columns.size()/nDims);
    for (label copyi = 0; copyi < sums.size(); ++copyi)
    {
        sums[copyi] = columns.segment(nDims*copyi, nDims).sum();
    }
    return sums;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::groupContact::groupContact(const bodyGroup& group)
:
    group_(group),
    areas_
    (
        contactBodies::nodeAreas
        (
            boundaryPoints(group.shape()),
            group.shape().faces(),
            group.shape().nDims(),
            group.shape().thickness()
        )
    ),
    products_(2),
    weights_(2)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::groupContact::probeNormals()
{
    const Eigen::MatrixXd& x = group_.positions();
    probe_.setZero(group_.shape().nBoundaryNodes(), x.cols());

    for (label column = 0; column < x.cols(); column += 2)
    {
        for (const surfaceFace& face : group_.shape().faces())
        {
            const scalar dx = x(face[1], column) - x(face[0], column);
            const scalar dy = x(face[1], column + 1) - x(face[0], column + 1);
            for (label i = 0; i < 2; ++i)
            {
                probe_(face[i], column) += dy;
                probe_(face[i], column + 1) -= dx;
            }
        }
    }
}


void Foam::fsi::groupContact::makeProduct(const label k, const scalar dt)
{
    const Eigen::MatrixXd& inverse =
        group_.shape().factor(dt).boundaryInverse();

    // N f = B f + r (r . f) - C' f, minus the terms known
    Eigen::MatrixXd& y = products_[k];
    group_.respondBoundary(probe_, y);
    y *= -1/dt;
    y.noalias() += inverse*probe_;

    const Eigen::VectorXd turn = products(rotation_, probe_, 2);
    for (label column = 0; column < y.cols(); ++column)
    {
        y.col(column) += turn[column/2]*rotation_.col(column);
    }
    for (label known = 0; known < k; ++known)
    {
        const Eigen::VectorXd amount =
            products(products_[known], probe_, 2)
           .cwiseProduct(weights_[known]);
        for (label column = 0; column < y.cols(); ++column)
        {
            y.col(column) -= amount[column/2]*products_[known].col(column);
        }
    }
    weights_[k] = products(y, probe_, 2).cwiseInverse();
}


void Foam::fsi::groupContact::addMode
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    const Eigen::MatrixXd& mode,
    const Eigen::VectorXd& coefficients,
    contactBodies& bodies
) const
{
    forAll(objects, copyi)
    {
        const label k = bodies.addMode(objects[copyi], coefficients[copyi]);
        const label start = surfaces.pointStart()[objects[copyi]];
        for (label i = 0; i < mode.rows(); ++i)
        {
            bodies.mode(start + i, k) =
                vector(mode(i, 2*copyi), mode(i, 2*copyi + 1), 0);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::groupContact::set
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    const scalar dt,
    const bool internalForces,
    contactBodies& bodies
)
{
    const label nBoundary = areas_.size();
    if (internalForces)
    {
        group_.internalForce(internalForce_);
    }

    forAll(objects, copyi)
    {
        const label start = surfaces.pointStart()[objects[copyi]];
        for (label i = 0; i < nBoundary; ++i)
        {
            bodies.areas()[start + i] = areas_[i];
            bodies.masses()[start + i] = group_.shape().nodeMasses()[i];
            if (internalForces)
            {
                bodies.internalForces()[start + i] = vector
                (
                    internalForce_(i, 2*copyi),
                    internalForce_(i, 2*copyi + 1),
                    0
                );
            }
        }
    }
    if (!group_.free() || objects.empty())
    {
        return;
    }

    const Eigen::MatrixXd* inverse =
        &group_.shape().factor(dt).boundaryInverse();
    for (const label objecti : objects)
    {
        bodies.setInverse(objecti, inverse);
    }

    rotation_ = group_.response().rotationModes().topRows(nBoundary);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(objects.size());
    addMode(surfaces, objects, rotation_, ones, bodies);

    probe_ = rotation_;
    makeProduct(0, dt);
    addMode(surfaces, objects, products_[0], -weights_[0], bodies);

    probeNormals();
    makeProduct(1, dt);
    addMode(surfaces, objects, products_[1], -weights_[1], bodies);
}


// ************************************************************************* //
