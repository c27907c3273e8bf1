// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidResponse.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::rigidResponse::makeModes()
{
    const scalarField& masses = shape_.nodeMasses();
    const direction nDims = shape_.nDims();
    addModes
    (
        modeKind::translation,
        1,
        rigidModes::translations(masses, nCopies(), nDims)
    );
    addModes
    (
        modeKind::rotation,
        1,
        rigidModes::rotations(masses, positions(), nDims)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rigidResponse::rigidResponse(const shapeTemplate& shape)
:
    bodyResponse(shape)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::rigidResponse::respondRoughly
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    v = force.colwise().sum().replicate(force.rows(), 1)/shape_.mass();
}


Foam::scalar Foam::fsi::rigidResponse::roughMobility
(
    const label,
    const label,
    const label
) const
{
    return 1/shape_.mass();
}


// ************************************************************************* //
