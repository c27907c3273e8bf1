// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsPressure.H"
#include "activeMean.H"
#include "dictionaryCheck.H"
#include "openfoamMesh.H"
#include "openfoamTypes.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Entries of the pressure in fvSolution. Fatal if its solver is unknown; the
//  log says so if it is another than the one of this coupling.
static dictionary checkedControls(const volScalarField& p)
{
    dictionary controls(solverControls(p.mesh(), p.name()));
    const word solver(getEntry<word>(controls, "solver"));
    const auto& known = *lduMatrix::solver::symMatrixConstructorTablePtr_;
    if (!known.found(solver))
    {
        FatalIOErrorInFunction(controls)
            << "Unknown choice '" << solver << "' of entry 'solver' in"
            << " dictionary " << controls.name() << nl
            << "Valid choices are " << flatOutput(known.sortedToc())
            << exit(FatalIOError);
    }
    if (solver != "cartesianMG")
    {
        Info<< "Pressure equation: solved by cartesianMG with the objects'"
            << " response; 'solver " << solver << "' of " << p.name()
            << " is for coupling weak" << nl << endl;
    }
    if (p.mesh().nGeometricD() == 2)
    {
        // Objects bound the number of iterations, not the large levels. In 3D
        // a second visit to these costs less, and they count
        controls.add("wCycleCells", multigridHierarchy::controls().gatherCells);
    }
    return controls;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectsPressure::updateMultigrid
(
    const volScalarField& p,
    fvScalarMatrix& pEqn,
    const stepLength& step
)
{
    const auto interfaces = p.boundaryField().scalarInterfaces();
    if (conductance_.none())
    {
        multigrid_.update(pEqn, boundaryCoeffsOf(pEqn), interfaces);
        return;
    }

    // Cells inside the objects conduct in the cycle, not in the equation,
    // whose cells that are not active have a diagonal of exactly zero
    const objectsConductance::faceValues g(conductance_.conductance(step));
    scalarField diagonal(pEqn.diag());
    objectsConductance::add(g, 1, pEqn);
    multigrid_.update(pEqn, boundaryCoeffsOf(pEqn), interfaces);
    objectsConductance::add(g, -1, pEqn);
    pEqn.diag().swap(diagonal);
    multigrid_.updateProduct
    (
        pEqn, boundaryCoeffsOf(pEqn), interfaces, g.faces
    );
}


Foam::scalar Foam::fsi::objectsPressure::energy(const vectorField& U) const
{
    const boolList& fluid = geometry_.fluidCell();
    scalar squares = 0;
    forAll(U, celli)
    {
        squares += fluid[celli] ? magSqr(U[celli]) : 0;
    }
    return squares*geometry_.grid().cellVolume();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectsPressure::objectsPressure
(
    fsiObjects& objects,
    const interfaceGeometry& geometry,
    const wallOperator& walls,
    const volScalarField& p
)
:
    geometry_(geometry),
    log_(objects.log()),
    conductance_(objects, geometry, walls),
    multigrid_(p.mesh(), checkedControls(p)),
    rate_
    (
        IOobject
        (
            "pressureRate",
            nameOf(geometry.grid().mesh().time()),
            geometry.grid().mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        geometry.grid().mesh(),
        dimensionedScalar(sqr(dimVelocity)/dimTime, Zero)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectsPressure::beginStep(volScalarField& p)
{
    const boolList& active = geometry_.activeCell();
    const scalar dt = p.time().deltaTValue();
    forAll(active, celli)
    {
        const scalar start = p[celli];
        p[celli] += active[celli] ? dt*rate_[celli] : 0;
        rate_[celli] = start;
    }
}


void Foam::fsi::objectsPressure::endStep(volScalarField& p)
{
    const scalar dt = p.time().deltaTValue();
    forAll(p, celli)
    {
        rate_[celli] = (p[celli] - rate_[celli])/dt;
    }
    if (p.needReference())
    {
        const boolList& active = geometry_.activeCell();
        const scalar level = activeMean(rate_.primitiveField(), active);
        forAll(p, celli)
        {
            rate_[celli] -= active[celli] ? level : 0;
            p[celli] -= active[celli] ? dt*level : 0;
        }
        p.correctBoundaryConditions();
    }
}


void Foam::fsi::objectsPressure::solve
(
    volScalarField& p,
    fvScalarMatrix& pEqn,
    scalarField& b,
    const addedTerm* term,
    const scalarField& inside,
    const vectorField* U,
    const stepLength& step
)
{
    const boolList& active = geometry_.activeCell();
    addPatchParts(active, p, pEqn, b);
    updateMultigrid(p, pEqn, step);

    const dictionary& controls = solverControls(p.mesh(), p.name());
    cartesianMultigrid::loopControls loop;
    loop.tolerance = controls.lookupOrDefault<scalar>("tolerance", 1e-6);
    loop.relTol = controls.lookupOrDefault<scalar>("relTol", 0);
    loop.maxIter = readAtLeast(controls, "maxIter", 1000, 1);
    loop.energy = U ? energy(*U)/step.tau : -1;
    const auto performance = multigrid_.solve
    (
        p.primitiveFieldRef(), b, p.name(), loop, term
    );
    log_.solved(performance);
    keepResiduals(p.mesh(), performance);

    // Inside the objects nothing is solved for
    forAll(active, celli)
    {
        if (!active[celli])
        {
            p[celli] = inside[celli];
        }
    }
    p.correctBoundaryConditions();
}


// ************************************************************************* //
