// SPDX-License-Identifier: GPL-3.0-or-later

#include "suddenAcceleration.H"
#include "openfoamMesh.H"
#include "openLaplacian.H"
#include "openfoamVersion.H"
#include "rigidForce.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::suddenAcceleration::suddenAcceleration(const fsiSystem& system)
:
    bodiesTerm(system),
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
        system_.objects.groups()[groupi].movesFreely()
      ? system_.bodyAcceleration(groupi, gravity_, driving_)
      : Zero;
}


Foam::scalar Foam::fsi::suddenAcceleration::largestDifference() const
{
    scalar largest = 0;
    forAll(system_.objects.groups(), groupi)
    {
        if (system_.objects.groups()[groupi].size())
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
    const bodyGroup& group = system_.objects.groups()[groupi];
    velocity.setZero();
    if (group.movesFreely())
    {
        addRigidAcceleration(group, force, velocity);
        velocity *= system_.deltaT();
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::suddenAcceleration::flux
(
    const volScalarField& p
) const
{
    const fvMesh& mesh = p.mesh();
    const surfaceScalarField& open = system_.geometry.openArea();
    const vector step(system_.deltaT()*driving_);
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::suddenAcceleration::update(const volScalarField& p)
{
    bool starts = p.time().timeIndex() == 1;
    if (starts)
    {
        const scalar high = overRanks(max(p.primitiveField()), maxOp<scalar>());
        const scalar low = overRanks(min(p.primitiveField()), minOp<scalar>());
        starts = high - low < VSMALL;
    }
    gravity_ = starts ? system_.gravity : vector(Zero);
    driving_ =
        starts ? system_.driving->acceleration() : system_.driving->change();
    const scalar velocity = system_.deltaT()*largestDifference();
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
    subtractGradient(system_.geometry, p, -system_.deltaT(), fluxes);

    vectorField lastPart;
    velocity(system_.walls.atWalls(p.primitiveField()), lastPart);
    const labelList& object = system_.objects.surfaces().pointObject();
    forAll(lastPart, nodei)
    {
        lastPart[nodei] -=
            system_.deltaT()
           *bodyChange(system_.objects.objectGroup(object[nodei]));
    }
    source.setSize(p.size());
    system_.walls.flux(lastPart, source);
    subtractOutflow(fluxes, source);
}


// ************************************************************************* //
