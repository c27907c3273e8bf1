// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneMatrix.H"
#include "error.H"
#include "innerFlow.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::membraneMatrix::addStretching
(
    const scalar dt,
    const Eigen::Ref<const Eigen::MatrixXd>& x
)
{
    const label n = x.rows();
    forAll(shape_.springs(), springi)
    {
        const edge& ends = shape_.springs()[springi];
        const scalar d[2] =
        {
            x(ends[1], 0) - x(ends[0], 0),
            x(ends[1], 1) - x(ends[0], 1)
        };
        const scalar square = d[0]*d[0] + d[1]*d[1];
        const scalar k = sqr(dt)*shape_.springConstants()[springi];
        const scalar across = k*max
        (
            1 - shape_.restLengths()[springi]/std::sqrt(square),
            scalar(0)
        );

        for (int i = 0; i < 2; ++i)
        {
            for (int j = 0; j < 2; ++j)
            {
                const scalar value =
                    (k - across)*d[i]*d[j]/square + (i == j ? across : 0);
                const label a = ends[0], b = ends[1];
                entries_.emplace_back(a + n*i, a + n*j, value);
                entries_.emplace_back(b + n*i, b + n*j, value);
                entries_.emplace_back(a + n*i, b + n*j, -value);
                entries_.emplace_back(b + n*i, a + n*j, -value);
            }
        }
    }
}


void Foam::fsi::membraneMatrix::makeEntries
(
    const scalar dt,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const List<bodyElement>& triangles
)
{
    const label n = shape_.nNodes();
    const scalar viscosity =
        shape_.membrane()->innerViscosity*shape_.thickness();

    entries_.clear();
    for (label i = 0; i < 2*n; ++i)
    {
        entries_.emplace_back(i, i, shape_.nodeMasses()[i % n]);
    }
    innerFlow::addViscosity(triangles, x, viscosity, dt, entries_);
    addStretching(dt, x);
    shape_.bending().addStiffness(x, sqr(dt), entries_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneMatrix::membraneMatrix(const shapeTemplate& shape)
:
    shape_(shape)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneMatrix::prepare
(
    const scalar dt,
    const Eigen::MatrixXd& positions,
    const List<List<bodyElement>>& triangles
)
{
    copies_.resize(triangles.size());
    forAll(triangles, copyi)
    {
        makeEntries(dt, positions.middleCols(2*copyi, 2), triangles[copyi]);
        if (!copies_[copyi])
        {
            copies_[copyi] = std::make_unique<copyMatrix>();
        }
        copyMatrix& copy = *copies_[copyi];
        copy.boundaryInverse.resize(0, 0);
        if (copy.triangles != triangles[copyi])
        {
            copy.triangles = triangles[copyi];
            copy.matrix.setPattern(shape_.nNodes(), entries_);
        }
        copy.matrix.set(entries_);
        if (!copy.factor.factor(copy.matrix.pattern(), copy.matrix.values()))
        {
            FatalErrorInFunction
                << "The matrix of copy " << copyi << " of the membrane "
                << shape_.name() << " for the time step " << dt
                << " s is not positive definite" << exit(FatalError);
        }
    }
}


Eigen::MatrixXd Foam::fsi::membraneMatrix::multiply
(
    const Eigen::MatrixXd& x
) const
{
    Eigen::MatrixXd result(x.rows(), x.cols());
    for (label copyi = 0; copyi < x.cols()/2; ++copyi)
    {
        matrix(copyi).multiply
        (
            x.col(2*copyi).data(),
            result.col(2*copyi).data()
        );
    }
    return result;
}


const Eigen::MatrixXd& Foam::fsi::membraneMatrix::boundaryInverse
(
    const label copyi
) const
{
    copyMatrix& copy = *copies_[copyi];
    if (copy.boundaryInverse.size() == 0)
    {
        copy.boundaryInverse = copy.factor.inverse(shape_.nBoundaryNodes());
    }
    return copy.boundaryInverse;
}


void Foam::fsi::membraneMatrix::solve(Eigen::MatrixXd& b) const
{
    for (label copyi = 0; copyi < b.cols()/2; ++copyi)
    {
        copies_[copyi]->factor.solve(b.col(2*copyi).data());
    }
}


void Foam::fsi::membraneMatrix::solveBoundary
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    v.resize(f.rows(), f.cols());
    for (label copyi = 0; copyi < f.cols()/2; ++copyi)
    {
        Eigen::Map<Eigen::VectorXd>(v.col(2*copyi).data(), 2*f.rows()).noalias()
      = boundaryInverse(copyi)*Eigen::Map<const Eigen::VectorXd>
        (
            f.col(2*copyi).data(),
            2*f.rows()
        );
    }
}


// ************************************************************************* //
