// SPDX-License-Identifier: GPL-3.0-or-later

#include "suddenAcceleration.H"
#include "objectResponse.H"
#include "openfoamMesh.H"
#include "openLaplacian.H"
#include "openfoamVersion.H"
#include "rigidForce.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::suddenAcceleration::suddenAcceleration
(
    fsiObjects& objects,
    const interfaceGeometry& geometry,
    const wallOperator& walls
)
:
    bodiesTerm(objects.bodies(), walls, objects.fluid().density),
    objects_(objects),
    geometry_(geometry),
    deltaT_(0),
    gravity_(Zero),
    driving_(Zero)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::suddenAcceleration::bodyChange
(
    const label groupi
) const
{
    return
        bodies_.groups()[groupi].movesFreely()
      ? objects_.fluid().accelerationOf
        (
            bodies_.shape(groupi).density(), gravity_, driving_
        )
      : Zero;
}


Foam::scalar Foam::fsi::suddenAcceleration::largestDifference() const
{
    scalar largest = 0;
    forAll(bodies_.groups(), groupi)
    {
        if (bodies_.nCopies(groupi))
        {
            largest = max(largest, mag(bodyChange(groupi) - driving_));
        }
    }
    return largest;
}


void Foam::fsi::suddenAcceleration::respond
(
    const label groupi,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& velocity
) const
{
    const bodyGroup& group = bodies_.groups()[groupi];
    velocity.setZero();
    if (group.movesFreely())
    {
        addRigidAcceleration(group, force, velocity);
        velocity *= deltaT_;
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::suddenAcceleration::flux
(
    const volScalarField& p
) const
{
    const fvMesh& mesh = p.mesh();
    const surfaceScalarField& open = geometry_.openArea();
    const vector step(deltaT_*driving_);
    auto tflux = newTmp<surfaceScalarField>
    (
        IOobject("suddenFlux", nameOf(mesh.time()), mesh),
        mesh,
        dimVelocity*dimArea
    );
    surfaceScalarField& flux = tflux.ref();
    setOriented(flux);
    flux.primitiveFieldRef() =
        open.primitiveField()*(mesh.Sf().primitiveField() & step);
    forAll(flux.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        fvsPatchScalarField& pf = flux.boundaryFieldRef()[patchi];
        pf = Zero;
        if (pp.coupled() || pp.fixesValue())
        {
            pf = open.boundaryField()[patchi]*(pp.patch().Sf() & step);
        }
    }
    return tflux;
}


bool Foam::fsi::suddenAcceleration::update(const volScalarField& p)
{
    bool starts = p.time().timeIndex() == 1;
    if (starts)
    {
        const scalar high = overRanks(max(p.primitiveField()), maxOp<scalar>());
        const scalar low = overRanks(min(p.primitiveField()), minOp<scalar>());
        starts = high - low < VSMALL;
    }
    gravity_ = starts ? objects_.gravity() : vector(Zero);
    const drivingForce& driving = objects_.driving();
    driving_ = starts ? driving.acceleration() : driving.change();
    const scalar velocity = deltaT_*largestDifference();
    if (!(velocity > VSMALL) || starts)
    {
        return velocity > VSMALL;
    }
    const scalarField& V = p.mesh().V();
    const vectorField& U =
        p.mesh().lookupObject<volVectorField>("U").primitiveField();
    const scalar squares = overRanks(sum(V*magSqr(U)), sumOp<scalar>());
    return velocity > 0.01*sqrt(squares/overRanks(sum(V), sumOp<scalar>()));
}


void Foam::fsi::suddenAcceleration::setSource
(
    const volScalarField& p,
    scalarField& source
) const
{
    // As for the pressure of a step: what p^n has is taken back
    const tmp<surfaceScalarField> tflux(flux(p));
    surfaceScalarField fluxes(tflux());
    subtractGradient(geometry_, p, -deltaT_, 0, fluxes);

    vectorField lastPart;
    velocity(walls_.atWalls(p.primitiveField()), lastPart);
    const labelList& object = bodies_.surfaces().pointObject();
    forAll(lastPart, nodei)
    {
        lastPart[nodei] -=
            deltaT_
           *bodyChange(bodies_.objectGroup(object[nodei]));
    }
    source.setSize(p.size());
    walls_.flux(lastPart, source);
    subtractOutflow(fluxes, source);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::suddenAcceleration::answer
(
    volScalarField& last,
    objectsPressure& pressure,
    const stepLength& step
)
{
    deltaT_ = step.dt;
    if (!update(last))
    {
        return;
    }
    const scalarField before(last.primitiveField());
    tmp<fvScalarMatrix> pEqn(openLaplacian(geometry_, last, deltaT_, 0));
    scalarField source;
    setSource(last, source);
    pressure.solve(last, pEqn.ref(), source, this, before, nullptr, step);
    expectPressure
    (
        objects_.bodies(),
        walls_,
        objects_.fluid().density,
        last.primitiveField() - before
    );
}


// ************************************************************************* //
