// SPDX-License-Identifier: GPL-3.0-or-later

#include "carriedScalar.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "fsiObjects.H"
#include "objectWriter.H"
#include "openVolumes.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::carriedScalar::addFluxes(scalarField& source)
{
    const population& bodies = objects_.bodies();
    for (const cellWall& part : geometry_.surfaceParts())
    {
        const label groupi = bodies.objectGroup(part.place.object);
        const auto& surface = surfaces_.all()[groupi];
        if (surface.type == scalarSurfaces::flux)
        {
            const scalar rate = surface.value*mag(part.area);
            source[part.cell] += rate;
            fromSurfaces_[groupi] += rate;
        }
    }
}


Foam::scalar Foam::fsi::carriedScalar::inflow
(
    const fvScalarMatrix& equation
) const
{
    scalar sum = 0;
    forAll(C_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pC = C_.boundaryField()[patchi];
        const labelUList& cells = pC.patch().faceCells();
        for (label i = 0; i < pC.size() && !pC.coupled(); ++i)
        {
            sum +=
                boundaryCoeffsOf(equation)[patchi][i]
              - internalCoeffsOf(equation)[patchi][i]*C_[cells[i]];
        }
    }
    return sum;
}


void Foam::fsi::carriedScalar::spread(const fvScalarMatrix& equation)
{
    // Sum of the residuals of all cells that are not fixed, which have no
    // coefficients of fixed ones; their volume
    const boolList& fixed = surfaces_.fixed();
    scalarList sums({0, 0, 0});
    forAll(fixed, celli)
    {
        if (!fixed[celli])
        {
            sums[2] += mag(equation.source()[celli]);
            sums[0] +=
                equation.source()[celli] - equation.diag()[celli]*C_[celli];
            sums[1] += volumes_.now()[celli];
        }
    }
    const labelUList& own = C_.mesh().owner();
    const labelUList& nei = C_.mesh().neighbour();
    forAll(own, facei)
    {
        sums[0] -=
            equation.upper()[facei]*C_[nei[facei]]
          + equation.lower()[facei]*C_[own[facei]];
    }
    forAll(C_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pC = C_.boundaryField()[patchi];
        const scalarField& ofOther = boundaryCoeffsOf(equation)[patchi];
        const scalarField& ofCell = internalCoeffsOf(equation)[patchi];
        scalarField across(pC.size(), scalar(1));
        if (pC.coupled())
        {
            across = pC.patchNeighbourField();
        }
        sums[0] += sum(ofOther*across - ofCell*pC.patchInternalField());
    }
    sumOverRanks(sums);
    if (mag(sums[0]) <= 10*SMALL*sums[2])
    {
        // The sum's own round-off
        return;
    }
    const scalar shift = objects_.deltaT()*sums[0]/max(sums[1], VSMALL);
    forAll(fixed, celli)
    {
        C_[celli] += fixed[celli] ? 0 : shift;
    }
}


void Foam::fsi::carriedScalar::write(const scalar inflow)
{
    scalar least = GREAT;
    scalar largest = -GREAT;
    scalarList sums(2 + fromSurfaces_.size(), Zero);
    sums[0] = 0;
    sums[1] = inflow;
    forAll(fromSurfaces_, groupi)
    {
        sums[2 + groupi] = fromSurfaces_[groupi];
    }
    forAll(C_, celli)
    {
        if (!surfaces_.fixed()[celli])
        {
            sums[0] += volumes_.now()[celli]*C_[celli];
        }
        if (geometry_.fluidCell()[celli])
        {
            least = min(least, C_[celli]);
            largest = max(largest, C_[celli]);
        }
    }
    sumOverRanks(sums);
    least = overRanks(least, minOp<scalar>());
    largest = overRanks(largest, maxOp<scalar>());
    if (table_.valid())
    {
        csvTable::rowWriter row(table_());
        row << C_.mesh().time().value() << sums[0] << least << largest;
        for (label i = 1; i < sums.size(); ++i)
        {
            row << sums[i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::carriedScalar::carriedScalar
(
    fsiObjects& objects,
    const interfaceGeometry& geometry,
    const word& name,
    const dictionary& dict
)
:
    objects_(objects),
    geometry_(geometry),
    C_
    (
        IOobject
        (
            name,
            nameOf(objects.grid().mesh().time()),
            objects.grid().mesh(),
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        objects.grid().mesh()
    ),
    surfaces_(objects, geometry, dict.subOrEmptyDict("surfaces")),
    transport_
    (
        geometry, surfaces_, C_, readPositive(dict, "diffusivity")
    ),
    fixed_(geometry, surfaces_, C_),
    volumes_
    (
        objects.grid(),
        name + "Volume",
        openVolumes(objects, geometry, surfaces_)()
    ),
    fromSurfaces_(surfaces_.all().size(), Zero),
    expansion_(0),
    reference_(0)
{
    checkKeys(dict, {"diffusivity", "surfaces", "buoyancy"});
    checkSubDicts(dict, {"surfaces", "buoyancy"});
    if (dict.found("buoyancy"))
    {
        const dictionary& buoyancy = dict.subDict("buoyancy");
        checkKeys(buoyancy, {"expansion", "reference"});
        expansion_ = readEntry<scalar>(buoyancy, "expansion");
        reference_ = readEntryOr<scalar>(buoyancy, "reference", 0);
    }
    wordList columns({"time", "amount", "least", "largest", "inflow"});
    for (const bodyGroup& group : objects.bodies().groups())
    {
        columns.append(group.shape().name());
    }
    table_ =
        objectWriter::newTable(objects.grid().mesh().time(), name, columns);
    fixed_.setValues();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::carriedScalar::addBuoyancy(vectorField& source) const
{
    if (expansion_ == 0)
    {
        return;
    }
    const scalar whole = objects_.grid().faceArea()*objects_.grid().spacing();
    const vector perDifference(-whole*expansion_*objects_.gravity());
    forAll(source, celli)
    {
        if (geometry_.fluidCell()[celli])
        {
            source[celli] += (C_[celli] - reference_)*perDifference;
        }
    }
}



void Foam::fsi::carriedScalar::advance(const surfaceScalarField& phi)
{
    const scalar perStep = 1/objects_.deltaT();
    const boolList wasFixed(surfaces_.fixed());
    const scalarField last(C_.primitiveField());
    surfaces_.update();
    fixed_.setValues();

    surfaceScalarField flux(C_.name() + "Flux", phi);
    boolList free(C_.size());
    forAll(free, celli)
    {
        free[celli] = surfaces_.fixed()[celli] || surfaces_.beside()[celli];
    }
    const tmp<scalarField> ttaken
    (
        volumes_.advance
        (
            openVolumes(objects_, geometry_, surfaces_),
            transport_.openFaces(),
            free,
            flux
        )
    );
    const scalarField& taken = ttaken();

    fvScalarMatrix equation(C_, C_.dimensions()*dimVolume/dimTime);
    transport_.set(flux, volumes_.field(), equation);
    fixed_.addLinks(transport_.diffusivity(), equation);
    fromSurfaces_ = Zero;
    addFluxes(equation.source());
    forAll(taken, celli)
    {
        const scalar before = perStep*volumes_.last()[celli]*last[celli];
        equation.diag()[celli] +=
            perStep*(volumes_.now()[celli] - taken[celli]);
        equation.source()[celli] += before;
        const bool fixed = surfaces_.fixed()[celli];
        if (fixed != wasFixed[celli])
        {
            fromSurfaces_[surfaces_.group()[celli]] += fixed ? -before : before;
        }
    }
    fixed_.fix(objects_.deltaT(), equation);
    objects_.log().solved
    (
        quietly(equation, solverControls(C_.mesh(), C_.name()))
    );
    fixed_.count(perStep*taken, fromSurfaces_);
    const scalar in = inflow(equation);
    spread(equation);
    C_.correctBoundaryConditions();
    write(in);
}


// ************************************************************************* //
