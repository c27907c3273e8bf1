// SPDX-License-Identifier: GPL-3.0-or-later

#include "deformableResponse.H"
#include "bodyVolume.H"
#include "columnBasis.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::deformableResponse::solveModes
(
    rigidModes::modeList& modes
) const
{
    if (shape_.nDims() == 3)
    {
        columnBasis basis(modes, shape_.nDims());
        matrix().solve(basis.values());
        basis.combine(modes);
        return;
    }
    for (Eigen::MatrixXd& mode : modes)
    {
        matrix().solve(mode);
    }
}


Foam::fsi::rigidModes::modeList Foam::fsi::deformableResponse::elasticParts
(
    const rigidModes::modeList& rotations
) const
{
    const Eigen::Map<const Eigen::VectorXd> m
    (
        masses().cdata(),
        shape_.nNodes()
    );
    const label n(rotations.size());
    const direction nDims = shape_.nDims();
    rigidModes::modeList momenta(n);
    for (label k = 0; k < n; ++k)
    {
        momenta[k] = m.asDiagonal()*rotations[k];
    }
    rigidModes::modeList parts(momenta);
    solveModes(parts);

    rigidModes::smallMatrix products(n, n);
    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        for (label k = 0; k < n; ++k)
        {
            for (label l = 0; l <= k; ++l)
            {
                products(k, l) = products(l, k) =
                    rigidModes::product(parts[k], momenta[l], nDims, copyi);
            }
        }
        rigidModes::orthonormalise(parts, products, nDims, copyi);
    }
    return parts;
}


void Foam::fsi::deformableResponse::holdMotions
(
    rigidModes::modeList& rotations
)
{
    heldModes_.clear();
    const direction nDims = shape_.nDims();
    if (!freedom_.movesFreely())
    {
        const bodyFreedom all(nDims);
        bodyFreedom::axes held;
        for (const direction d : all.translations())
        {
            if (!isIn(freedom_.translations(), d))
            {
                held.append(d);
            }
        }
        for
        (
            Eigen::MatrixXd& t
          : rigidModes::translations(masses(), nCopies(), nDims, held)
        )
        {
            heldModes_.push_back({modeKind::translation, -1, t});
            modes_.push_back(heldModes_.back());
        }
    }
    if (!freedom_.turnsFreely())
    {
        for (const Eigen::MatrixXd& r : rotations)
        {
            heldModes_.push_back({modeKind::rotation, -1, r});
        }
        rotations = rigidModes::rotations
        (
            masses(), positions(), nDims, freedom_.rotations()
        );
        for (const Eigen::MatrixXd& r : rotations)
        {
            heldModes_.push_back({modeKind::rotation, 1, r});
        }
    }
}


void Foam::fsi::deformableResponse::addVolumeMode()
{
    const Eigen::MatrixXd& x = positions();
    const label nDims = shape_.nDims();
    Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(x.rows(), x.cols());
    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        bodyVolume::addGradient
        (
            shape_.faces(),
            shape_.thickness(),
            x.middleCols(nDims*copyi, nDims),
            gradient.middleCols(nDims*copyi, nDims)
        );
    }

    Eigen::MatrixXd c(gradient);
    matrix().solve(c);
    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        auto own = c.middleCols(nDims*copyi, nDims);
        for (const mode& m : modes_)
        {
            const scalar amount = m.sign
               *rigidModes::product(m.values, gradient, nDims, copyi);
            own += amount*m.values.middleCols(nDims*copyi, nDims);
        }
        own /= std::sqrt(rigidModes::product(c, gradient, nDims, copyi));
    }
    addModes(modeKind::volume, -1, rigidModes::modeList(1, c));
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::deformableResponse::makeModes()
{
    rigidModes::modeList rotations
    (
        rigidModes::rotations
        (
            masses(),
            positions(),
            shape_.nDims(),
            bodyFreedom(shape_.nDims()).rotations()
        )
    );
    rigidModes::modeList elastic(elasticParts(rotations));
    holdMotions(rotations);
    addModes(modeKind::rotation, 1, std::move(rotations));
    addModes(modeKind::elasticRotation, -1, std::move(elastic));
    addVolumeMode();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::deformableResponse::deformableResponse
(
    const shapeTemplate& shape,
    const bodyFreedom& freedom
)
:
    bodyResponse(shape, true),
    freedom_(freedom)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::deformableResponse::hold(Eigen::MatrixXd& v) const
{
    if (heldModes_.empty())
    {
        return;
    }
    const direction nDims = shape_.nDims();
    const Eigen::Map<const Eigen::VectorXd> m(masses().cdata(), v.rows());
    const Eigen::MatrixXd momenta(m.asDiagonal()*v);
    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        for (const mode& held : heldModes_)
        {
            const scalar amount = held.sign
               *rigidModes::product(held.values, momenta, nDims, copyi);
            v.middleCols(nDims*copyi, nDims) +=
                amount*held.values.middleCols(nDims*copyi, nDims);
        }
    }
}


void Foam::fsi::deformableResponse::constrainVolume
(
    const scalar dt,
    const Eigen::MatrixXd& start,
    Eigen::MatrixXd& v
) const
{
    const label nB = shape_.nBoundaryNodes();
    const label nDims = shape_.nDims();
    Eigen::MatrixXd end(nB, nDims);

    for (label copyi = 0; copyi < nCopies(); ++copyi)
    {
        const auto mode =
            modes_.back().values.middleCols(nDims*copyi, nDims);
        end =
            start.middleCols(nDims*copyi, nDims).topRows(nB)
          + dt*v.middleCols(nDims*copyi, nDims).topRows(nB);

        // From the velocity as it is
        const bodyVolume volume(shape_.faces(), end, mode.topRows(nB));
        const scalar factor = volume.factorFor(shape_.referenceVolume());
        v.middleCols(nDims*copyi, nDims) += (factor/dt)*mode;
    }
}


// ************************************************************************* //
