// SPDX-License-Identifier: GPL-3.0-or-later

#include "meanFluidVelocity.H"
#include "levelSetUpdate.H"
#include "sumOverRanks.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::meanFluidVelocity
(
    const volVectorField& U,
    const levelSetUpdate& levelSet,
    const labelList& halo
)
{
    const scalarField& V = U.mesh().V();
    scalar volume = 0;
    vector sum(Zero);
    forAll(halo, celli)
    {
        if (levelSet.cellDistance()[halo[celli]] > 0)
        {
            volume += V[celli];
            sum += V[celli]*U[celli];
        }
    }
    sum = overRanks(sum, sumOp<vector>());
    volume = overRanks(volume, sumOp<scalar>());
    return sum/max(volume, VSMALL);
}


// ************************************************************************* //
