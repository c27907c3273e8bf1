// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsTerm.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectsTerm::respond
(
    const label groupi,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& velocity
) const
{
    bodies_.groups()[groupi].response().respondBoundary
    (
        force,
        velocity
    );
}


// ************************************************************************* //
