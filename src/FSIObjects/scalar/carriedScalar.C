// SPDX-License-Identifier: GPL-3.0-or-later

#include "carriedScalar.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "fsiObjects.H"
#include "objectWriter.H"
#include "openVolumes.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::fsi::carriedScalar::capacity() const
{
    const scalar whole = objects_.grid().cellVolume();
    auto tcapacity = newTmp<scalarField>(open_);
    forAll(open_, celli)
    {
        tcapacity.ref()[celli] +=
            surfaces_.partition(celli)*(whole - open_[celli]);
    }
    return tcapacity;
}


Foam::tmp<Foam::volScalarField> Foam::fsi::carriedScalar::share() const
{
    const scalar whole = objects_.grid().cellVolume();
    auto tshare = newTmp<volScalarField>(C_.name() + "Share", volumes_.field());
    volScalarField& share = tshare.ref();
    forAll(open_, celli)
    {
        const scalar K = surfaces_.partition(celli);
        share[celli] /= K > 0 ? min(K, scalar(1))*whole : whole;
    }
    share.correctBoundaryConditions();
    return tshare;
}


void Foam::fsi::carriedScalar::addSources(scalarField& source)
{
    const scalar whole = objects_.grid().cellVolume();
    forAll(open_, celli)
    {
        if (surfaces_.partition(celli) > 0)
        {
            const scalar made =
                surfaces_.value(celli)*(whole - open_[celli]);
            source[celli] += made;
            fromSurfaces_[surfaces_.group()[celli]] += made;
        }
    }
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
        objects, geometry, surfaces_, C_, readPositive(dict, "diffusivity")
    ),
    fixed_(geometry, surfaces_, C_),
    open_(openVolumes(objects, geometry, surfaces_)),
    volumes_(objects.grid(), heldVolumes::nameFor(name), capacity()()),
    bodyFlux_(objects, geometry, surfaces_),
    inBodies_(surfaces_.all().size(), Zero),
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
    forAll(surfaces_.all(), groupi)
    {
        if (surfaces_.all()[groupi].type == scalarSurfaces::permeable)
        {
            const word& shape =
                objects.bodies().groups()[groupi].shape().name();
            columns.append("in" + shape);
        }
    }
    table_ =
        objectWriter::newTable(objects.grid().mesh().time(), name, columns);
    fixed_.setValues();
    countBodies(0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::carriedScalar::addBuoyancy(vectorField& source) const
{
    if (!buoyant())
    {
        return;
    }
    const scalar whole = objects_.grid().cellVolume();
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
    open_ = openVolumes(objects_, geometry_, surfaces_);

    surfaceScalarField flux(C_.name() + "Flux", phi);
    if (surfaces_.anyPermeable())
    {
        bodyFlux_.addTo(flux);
    }
    boolList free(C_.size());
    forAll(free, celli)
    {
        free[celli] = surfaces_.fixed()[celli] || surfaces_.beside()[celli];
    }
    const tmp<scalarField> ttaken
    (
        volumes_.advance
        (
            capacity(),
            transport_.openFaces(),
            free,
            flux
        )
    );
    const scalarField& taken = ttaken();

    fvScalarMatrix equation(C_, C_.dimensions()*dimVolume/dimTime);
    transport_.set(flux, share(), equation);
    fixed_.addLinks(transport_.diffusivity(), equation);
    fromSurfaces_ = Zero;
    addSources(equation.source());
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
    countBodies(perStep);
    write(in);
}


// ************************************************************************* //
