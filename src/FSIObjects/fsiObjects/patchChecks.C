// SPDX-License-Identifier: GPL-3.0-or-later

#include "patchChecks.H"
#include "domainSides.H"
#include "errorOf.H"
#include "openfoamMesh.H"
#include "sharedPatches.H"
#include "sumOverRanks.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Largest speeds through the faces of each patch of all ranks, then the
//  largest speeds [m/s]
static scalarList speeds(const volVectorField& U, const label nPatches)
{
    scalarList largest(2*nPatches, Zero);
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const fvPatchVectorField& patch = U.boundaryField()[patchi];
        const scalarField through(mag(patch & patch.patch().nf()));
        forAll(through, i)
        {
            scalar& speed = largest[nPatches + patchi];
            speed = max(speed, mag(patch[i]));
            largest[patchi] = max(largest[patchi], through[i]);
        }
    }
    combineOverRanks(largest, maxEqOp<scalar>());
    return largest;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::patchChecks::check
(
    const volScalarField& p,
    const volVectorField& U,
    const bool frameMoves
)
{
    const polyBoundaryMesh& patches = U.mesh().boundaryMesh();
    const label nPatches = nSharedPatches(patches);
    const scalarList largest(speeds(U, nPatches));
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const word type(U.boundaryField()[patchi].type());
        const polyPatch& faces = patches[patchi];
        const bool given = type == "noSlip" || type == "fixedValue";
        const bool through =
            largest[patchi] > 1e-9*largest[nPatches + patchi];
        if (given && through && isA<wallPolyPatch>(faces))
        {
            FatalErrorInFunction
                << "Entry '" << faces.name() << "' in file " << pathOf(U)
                << " has a velocity through the patch, which is a wall: let it"
                << " be tangential, or make the patch one of type patch in"
                << " constant/polyMesh/boundary" << exit(FatalError);
        }
        if
        (
            given && !through && !frameMoves && domainSides::isOpen(faces)
         && !p.boundaryField()[patchi].fixesValue()
        )
        {
            FatalErrorInFunction
                << "Entry '" << faces.name() << "' in file " << pathOf(U)
                << " holds the fluid as a wall does, but objects leave through"
                << " the patch, which is of type " << faces.type()
                << ": make it one of type wall in constant/polyMesh/boundary"
                << exit(FatalError);
        }
    }
}


// ************************************************************************* //
