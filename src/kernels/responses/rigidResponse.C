// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidResponse.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::rigidResponse::makeModes()
{
    const direction nDims = shape_.nDims();
    addModes
    (
        modeKind::translation,
        1,
        rigidModes::translations
        (
            masses(), nCopies(), nDims, freedom_.translations()
        )
    );
    addModes
    (
        modeKind::rotation,
        1,
        rigidModes::rotations
        (
            masses(), positions(), nDims, freedom_.rotations()
        )
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rigidResponse::rigidResponse
(
    const shapeTemplate& shape,
    const bodyFreedom& freedom
)
:
    bodyResponse(shape),
    freedom_(freedom)
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
