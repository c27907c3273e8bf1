// SPDX-License-Identifier: GPL-3.0-or-later

#include "largestSpeed.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::largestSpeed(const List<Eigen::MatrixXd>& velocity)
{
    scalar largest = 0;
    for (const Eigen::MatrixXd& v : velocity)
    {
        largest = v.size() ? max(largest, v.cwiseAbs().maxCoeff()) : largest;
    }
    return largest;
}


Foam::scalar Foam::fsi::largestSpeed
(
    const volVectorField& U,
    const boolList& fluid
)
{
    scalar largest = 0;
    forAll(fluid, celli)
    {
        if (fluid[celli])
        {
            largest = max(largest, cmptMax(cmptMag(U[celli])));
        }
    }
    return overRanks(largest, maxOp<scalar>());
}


// ************************************************************************* //
