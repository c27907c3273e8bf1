// SPDX-License-Identifier: GPL-3.0-or-later

#include "fieldChecks.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "fluidRegions.H"
#include "openfoamMesh.H"
#include "patchChecks.H"
#include "population.H"
#include "sharedPatches.H"
#include "solverKeys.H"
#include "sumOverRanks.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Fatal if a value is no number or too large
template<class Type>
static void checkValues
(
    const IOobject& field,
    const word& place,
    const UList<Type>& values
)
{
    for (const Type& value : values)
    {
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            if (!isUsable(component(value, d)))
            {
                FatalErrorInFunction
                    << "Entry '" << place << "' in file " << pathOf(field)
                    << " has the value " << value << " but all must be < 1e15"
                    << exit(FatalError);
            }
        }
    }
}


static void checkDimensions
(
    const IOobject& field,
    const dimensionSet& given,
    const dimensionSet& needed,
    const char* what
)
{
    if (given != needed)
    {
        FatalErrorInFunction
            << "Entry 'dimensions' in file " << pathOf(field) << " is "
            << given << " but must be " << needed << ", " << what
            << exit(FatalError);
    }
}


template<class Field>
static void checkField(const Field& field)
{
    checkValues(field, "internalField", field.primitiveField());
    for (const auto& patch : field.boundaryField())
    {
        if (patch.coupled() && patch.type() != patch.patch().type())
        {
            FatalErrorInFunction
                << "Entry '" << patch.patch().name() << "' in file "
                << pathOf(field) << " is " << patch.type() << ", which makes a"
                << " jump that this solver does not know: take "
                << patch.patch().type() << ", and drivingForce (fsiProperties)"
                << " to drive the flow" << exit(FatalError);
        }
        checkValues
        (
            field, patch.patch().name(),
            static_cast<const UList<typename Field::value_type>&>(patch)
        );
    }
}


static void checkPressure(const volScalarField& p)
{
    for (const fvPatchScalarField& patch : p.boundaryField())
    {
        const word& name = patch.patch().name();
        if (patch.type() == "fixedFluxPressure")
        {
            FatalErrorInFunction
                << "Entry '" << name << "' in file " << pathOf(p)
                << " is fixedFluxPressure, which this solver does not know:"
                << " take zeroGradient" << exit(FatalError);
        }
        if (isA<wallPolyPatch>(patch.patch().patch()) && patch.fixesValue())
        {
            FatalErrorInFunction
                << "Entry '" << name << "' in file " << pathOf(p)
                << " gives the pressure at a wall: take zeroGradient, or make"
                << " it a patch" << exit(FatalError);
        }
    }
}


//- Controls of a field's solver
static void checkControls(const fvMesh& mesh, const word& field)
{
    const dictionary& solution = solutionControls(mesh);
    if (!solutionControls(mesh).subOrEmptyDict("solvers").isDict(field))
    {
        FatalIOErrorInFunction(solution)
            << "Entry 'solvers' in dictionary " << solution.name()
            << " has no dictionary '" << field << "'" << exit(FatalIOError);
    }
    const dictionary& controls = solverControls(mesh, field);
    wordList keys(solverKeys());
    if (field == "U")
    {
        // Of viscousCoupling
        keys.append(wordList({"responseTolerance", "responseMaxIter"}));
    }
    checkKeys(controls, keys);
    for (const word key : {"tolerance", "relTol"})
    {
        const scalar value = controls.lookupOrDefault<scalar>(key, 0);
        if (!(value >= 0 && value < 1))
        {
            FatalIOErrorInFunction(controls)
                << "Entry '" << key << "' in dictionary " << controls.name()
                << " is " << value << " but must be >= 0 and < 1"
                << exit(FatalIOError);
        }
    }
    if (!controls.found("tolerance"))
    {
        IOWarningInFunction(controls)
            << "Entry 'tolerance' is missing: its default is taken. Is it"
            << " spelled otherwise?" << nl << endl;
    }
}


//- Fatal if an inlet of given velocity has no cell with fluid behind it
static void checkInlets(const volVectorField& U, const boolList& active)
{
    // Cells of each patch behind faces with inflow: all of them, and those with
    // fluid
    const polyBoundaryMesh& patches = U.mesh().boundaryMesh();
    const label nPatches = nSharedPatches(patches);
    labelList counts(2*nPatches, Zero);
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const fvPatchVectorField& patch = U.boundaryField()[patchi];
        const polyPatch& faces = patches[patchi];
        if (faces.coupled() || isA<wallPolyPatch>(faces))
        {
            continue;
        }
        const scalarField inflow(-(patch & patch.patch().Sf()));
        forAll(inflow, i)
        {
            if (patch.fixesValue() && inflow[i] > 0)
            {
                ++counts[2*patchi];
                counts[2*patchi + 1] += active[faces.faceCells()[i]];
            }
        }
    }
    sumOverRanks(counts);
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        if (counts[2*patchi] > 0 && counts[2*patchi + 1] == 0)
        {
            FatalErrorInFunction
                << "Entry '" << patches[patchi].name() << "' in file "
                << pathOf(U)
                << " gives an inflow, but objects block the whole patch: no"
                << " velocity of the fluid can be found" << exit(FatalError);
        }
    }
}


//- Fatal if fluid is driven into a region that it cannot leave
static void checkRegions
(
    const volScalarField& p,
    const volVectorField& U,
    const population& bodies,
    const interfaceGeometry& geometry
)
{
    const surfaceSet& surfaces = bodies.surfaces();
    boolList moves(bodies.nHeld(), false);
    forAll(moves, objecti)
    {
        moves[objecti] = bodies.movesFreely(objecti);
    }
    forAll(surfaces.velocities(), pointi)
    {
        if (mag(surfaces.velocities()[pointi]) > 0)
        {
            moves[surfaces.pointObject()[pointi]] = true;
        }
    }
    scalar inflow = 0;
    const label patchi =
        fluidRegions(geometry, p).closedInlet(U, moves, inflow);
    if (patchi >= 0)
    {
        FatalErrorInFunction
            << "Entry '" << U.boundaryField()[patchi].patch().name()
            << "' in file " << pathOf(U) << " drives " << inflow
            << " m3/s into a part of the fluid that has no patch of given"
            << " pressure: it can go nowhere. Do objects close the channel?"
            << exit(FatalError);
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::fieldChecks::checkDimensions
(
    const volScalarField& p,
    const volVectorField& U
)
{
    fsi::checkDimensions
    (
        p, p.dimensions(), sqr(dimVelocity), "a pressure over a density"
    );
    fsi::checkDimensions(U, U.dimensions(), dimVelocity, "a velocity");
}


void Foam::fsi::fieldChecks::check
(
    const volScalarField& p,
    const volVectorField& U,
    const population& bodies,
    const interfaceGeometry& geometry,
    const bool frameMoves
)
{
    checkField(p);
    checkField(U);
    checkPressure(p);
    checkControls(p.mesh(), p.name());
    checkControls(p.mesh(), U.name());
    patchChecks::check(p, U, frameMoves);
    checkInlets(U, geometry.activeCell());
    checkRegions(p, U, bodies, geometry);
}


// ************************************************************************* //
