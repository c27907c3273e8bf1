// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMultigridCache.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cartesianMultigridCache, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianMultigridCache::cartesianMultigridCache
(
    const polyMesh& mesh
)
:
    MeshObject<polyMesh, GeometricMeshObject, cartesianMultigridCache>(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::fsi::cartesianMultigrid&
Foam::fsi::cartesianMultigridCache::updated
(
    const lduMatrix::solver& solver,
    const dictionary& controls
)
{
    const polyMesh& mesh =
        cartesianLattice::meshOf(solver.matrix().mesh());
    const word key
    (
        solver.fieldName()
      + '_' + controls.lookupOrDefault<word>("cycle", "W")
      + '_' + Foam::name(controls.lookupOrDefault<label>("wCycleFrom", -1))
      + '_' + Foam::name(controls.lookupOrDefault<label>("gatherCells", -1))
    );
    const auto& cache = cartesianMultigridCache::New(mesh);
    if (!cache.multigrids_.found(key))
    {
        cache.multigrids_.set(key, new cartesianMultigrid(mesh, controls));
    }
    cartesianMultigrid& multigrid = *cache.multigrids_[key];
    multigrid.update
    (
        solver.matrix(), solver.interfaceBouCoeffs(), solver.interfaces()
    );
    return multigrid;
}


// ************************************************************************* //
