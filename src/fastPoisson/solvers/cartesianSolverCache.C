// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianSolverCache.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cartesianSolverCache, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianSolverCache::cartesianSolverCache
(
    const polyMesh& mesh
)
:
    keptWithMesh<cartesianSolverCache>(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cartesianSolverCache::checkInterfaces
(
    const lduMatrix::solver& solver,
    const dictionary& controls
)
{
    const wordHashSet linear({"cyclic", "processor", "processorCyclic"});
    const lduInterfaceFieldPtrsList& interfaces = solver.interfaces();
    forAll(interfaces, patchi)
    {
        if (interfaces.set(patchi) && !linear.found(interfaces[patchi].type()))
        {
            FatalIOErrorInFunction(controls)
                << "Field " << solver.fieldName() << " has a coupled patch of"
                << " type " << interfaces[patchi].type() << ", which "
                << solver.type() << " does not know." << nl
                << "    Use 'solver PCG; preconditioner cartesianMG;' or GAMG."
                << exit(FatalIOError);
        }
    }
}


const Foam::fsi::cartesianMultigrid&
Foam::fsi::cartesianSolverCache::multigrid
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
      + '_' + Foam::name(controls.lookupOrDefault<label>("wCycleCells", -1))
      + '_' + Foam::name(controls.lookupOrDefault<label>("gatherCells", -1))
    );
    const auto& cache = cartesianSolverCache::New(mesh);
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


const Foam::fsi::cartesianTransform&
Foam::fsi::cartesianSolverCache::transform
(
    const lduMatrix::solver& solver,
    const bool exact
)
{
    const polyMesh& mesh =
        cartesianLattice::meshOf(solver.matrix().mesh());
    const auto& cache = cartesianSolverCache::New(mesh);
    const word& key = solver.fieldName();
    if (!cache.transforms_.found(key))
    {
        cache.transforms_.set(key, new cartesianTransform(mesh));
    }
    cartesianTransform& transform = *cache.transforms_[key];
    transform.update
    (
        solver.matrix(), solver.interfaceBouCoeffs(), solver.interfaces(),
        exact
    );
    return transform;
}


// ************************************************************************* //
