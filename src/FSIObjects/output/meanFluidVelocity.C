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
    vectorField sum(1, Zero);
    scalarField volume(1, Zero);
    forAll(halo, celli)
    {
        if (levelSet.cellDistance()[halo[celli]] > 0)
        {
            volume[0] += V[celli];
            sum[0] += V[celli]*U[celli];
        }
    }
    sumOverRanks(sum, volume);
    return sum[0]/max(volume[0], VSMALL);
}


// ************************************************************************* //
