// SPDX-License-Identifier: GPL-3.0-or-later

#include "activeMean.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::activeMean
(
    const scalarField& values,
    const boolList& active
)
{
    scalarList sums(2, Zero);
    forAll(values, celli)
    {
        sums[0] += active[celli] ? values[celli] : 0;
        sums[1] += active[celli];
    }
    sumOverRanks(sums);
    return sums[0]/max(sums[1], 1.0);
}


// ************************************************************************* //
