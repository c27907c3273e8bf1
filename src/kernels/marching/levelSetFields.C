// SPDX-License-Identifier: GPL-3.0-or-later

#include "levelSetFields.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::levelSetFields::start
(
    surfaceDistance& exact,
    const surfaceSet& surfaces,
    const cartesianBlock& block
)
{
    if (exact.bandWidth() < block.spacing())
    {
        FatalErrorInFunction
            << "The band of the exact distance is " << exact.bandWidth()
            << " m wide and misses samples beside the surfaces: it must be at"
            << " least the spacing of the samples, " << block.spacing() << " m"
            << exit(FatalError);
    }

    exact.update(surfaces, block);
    exact.extendVelocity(surfaces, block, velocity);
    phi = exact.distance();
    object = exact.object();

    seeds.clear();
    forAll(phi, samplei)
    {
        if (exact.nearestFace()[samplei] >= 0)
        {
            seeds.append(samplei);
        }
    }
}


void Foam::fsi::levelSetFields::start
(
    interfaceSeeds& interface,
    const cartesianBlock& block
)
{
    interface.update(block, phi);

    seeds = interface.samples();
    forAll(seeds, i)
    {
        phi[seeds[i]] = interface.distance()[i];
    }
    velocity.resize(block.size(), Zero);
    object.resize(block.size(), -1);
}


// ************************************************************************* //
