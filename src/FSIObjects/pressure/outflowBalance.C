// SPDX-License-Identifier: GPL-3.0-or-later

#include "outflowBalance.H"
#include "errorOf.H"
#include "inletOutletFvPatchFields.H"
#include "openfoamTime.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Can the outflow through a patch be another one?
static bool adjustable(const fvPatchVectorField& patch)
{
    return
       !patch.coupled()
     && (!patch.fixesValue() || isA<inletOutletFvPatchVectorField>(patch));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::balanceOutflow
(
    surfaceScalarField& phi,
    const volVectorField& U,
    const scalar covered
)
{
    // Outflow that can be scaled; all other flux out; what it would be if all
    // velocities were normal to their faces
    scalarList sums(3, Zero);
    forAll(phi.boundaryField(), patchi)
    {
        const fvsPatchScalarField& flux = phi.boundaryField()[patchi];
        if (flux.coupled())
        {
            continue;
        }
        const fvPatchVectorField& velocity = U.boundaryField()[patchi];
        const scalarField& areas = velocity.patch().magSf();
        const bool scales = adjustable(velocity);
        forAll(flux, i)
        {
            sums[scales && flux[i] > 0 ? 0 : 1] += flux[i];
            sums[2] += areas[i]*mag(velocity[i]);
        }
    }
    sumOverRanks(sums);
    const scalar outflow = sums[0];
    const scalar rest = sums[1] + covered;
    const scalar all = sums[2] + mag(covered);

    if (outflow > SMALL*all)
    {
        forAll(phi.boundaryField(), patchi)
        {
            fvsPatchScalarField& flux = phi.boundaryFieldRef()[patchi];
            const bool scales = adjustable(U.boundaryField()[patchi]);
            forAll(flux, i)
            {
                flux[i] *= scales && flux[i] > 0 ? -rest/outflow : 1;
            }
        }
    }
    else if (mag(rest) > 1e-8*all)
    {
        FatalErrorInFunction
            << "The velocities on the patches in file " << pathOf(U)
            << " bring " << -rest << " m3/s into the domain, of "
            << all << " m3/s through them, and no patch lets it out:"
            << " let one give the pressure, or make the velocities fit"
            << " what prescribed objects cover of them"
            << exit(FatalError);
    }
}


// ************************************************************************* //
