// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidViscosity.H"
#include "openfoamVersion.H"
#include "sumOverRanks.H"
#include "velocityGradient.H"
#include "wallViscosities.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

//- Viscosities at the shear rates of some gradients
void evaluate(viscosityLaw& law, const tensorField& gradients, scalarField& nu)
{
    scalarField rates(gradients.size());
    forAll(rates, i)
    {
        rates[i] = shearRate(gradients[i]);
    }
    law.viscosity(rates, nu);
}


//- The least and the largest number
struct bounds
{
    scalar least = GREAT;
    scalar largest = 0;

    //- A number that is none must not be lost
    void add(const scalar x)
    {
        least = x > least ? least : x;
        largest = x < largest ? largest : x;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fluidViscosity::makeFields()
{
    if (more_.valid())
    {
        return;
    }
    const fvMesh& mesh = geometry_.grid().mesh();
    more_.reset
    (
        new volScalarField
        (
            IOobject("moreViscosity", nameOf(mesh.time()), mesh),
            mesh,
            dimensionedScalar(dimVelocity*dimLength, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    stress_.reset(new varyingStress(geometry_, more_()));
}


void Foam::fsi::fluidViscosity::setBounds
(
    const FixedList<scalarField, 3>& atWalls
)
{
    const boolList& fluid = geometry_.fluidCell();
    bounds all;
    forAll(around_, celli)
    {
        if (fluid[celli])
        {
            all.add(around_[celli]);
        }
    }
    for (const fvPatchScalarField& pf : law_->field().boundaryField())
    {
        const labelUList& cells = pf.patch().faceCells();
        for (label i = 0; i < pf.size() && !pf.coupled(); ++i)
        {
            if (fluid[cells[i]])
            {
                all.add(pf[i]);
            }
        }
    }
    for (const scalarField& nu : atWalls)
    {
        for (const scalar nui : nu)
        {
            all.add(nui);
        }
    }
    const scalar least = overRanks(all.least, minOp<scalar>());
    const scalar largest = overRanks(all.largest, maxOp<scalar>());
    if (!(least > 0 && largest < GREAT))
    {
        FatalErrorInFunction
            << "At time " << nameOf(more_->time()) << " the viscosity of the"
            << " model " << law_->name() << " is from " << least << " to "
            << largest << " m2/s, but must be > 0 and < 1e15: see its"
            << " coefficients in constant/transportProperties"
            << exit(FatalError);
    }
    objects_.fluid().viscosity = least;
    objects_.fluid().largestViscosity = largest;
}


void Foam::fsi::fluidViscosity::setStress(const scalar least)
{
    more_->correctBoundaryConditions();
    if (!law_)
    {
        stress_->set(least);
        return;
    }
    forAll(more_->boundaryField(), i)
    {
        fvPatchScalarField& pm = more_->boundaryFieldRef()[i];
        if (!pm.coupled())
        {
            pm == law_->field().boundaryField()[i] - objects_.fluid().viscosity;
        }
    }
    stress_->set(moreAtLinks_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fluidViscosity::fluidViscosity
(
    fsiObjects& objects,
    interfaceGeometry& geometry,
    viscosityLaw* law
)
:
    objects_(objects),
    geometry_(geometry),
    law_(law)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fluidViscosity::update
(
    const volVectorField& U,
    const surfaceScalarField& phi
)
{
    if (!law_)
    {
        return;
    }
    makeFields();
    const vectorField& v = objects_.bodies().surfaces().velocities();
    gradient_ = velocityGradient(geometry_, U, v);
    evaluate(*law_, gradient_(), around_);
    volScalarField& field = law_->field();
    forAll(field.boundaryField(), patchi)
    {
        fvPatchScalarField& pf = field.boundaryFieldRef()[patchi];
        if (pf.size() && !pf.coupled())
        {
            evaluate(*law_, gradient_().boundaryField()[patchi], pf);
        }
    }
    FixedList<scalarField, 3> walls;
    setWallViscosities(*law_, geometry_, gradient_(), U, phi, v, walls);
    setBounds(walls);

    const scalar least = objects_.fluid().viscosity;
    moreAtLinks_ = walls[0] - least;
    for (scalarField& nu : walls)
    {
        nu /= least;
    }
    geometry_.setViscosities(walls[0], walls[1], walls[2]);
    forAll(around_, celli)
    {
        around_[celli] =
            geometry_.fluidCell()[celli] ? around_[celli] : least;
    }
    field.primitiveFieldRef() = around_;
    field.correctBoundaryConditions();
    more_->primitiveFieldRef() = around_ - least;
    setStress(0);
}


void Foam::fsi::fluidViscosity::setInside
(
    const scalarField& inside,
    const scalarField& fluidity,
    const scalar least
)
{
    makeFields();
    volScalarField& all = more_();
    const scalar nu = objects_.fluid().viscosity;
    forAll(all, celli)
    {
        const scalar outside = law_ ? nu + all[celli] : nu;
        all[celli] =
            1/(fluidity[celli] + (1 - inside[celli])/outside) - nu;
    }
    if (law_)
    {
        law_->field().primitiveFieldRef() =
            nu + all.primitiveField();
    }
    setStress(least);
}


void Foam::fsi::fluidViscosity::addTo(fvVectorMatrix& UEqn) const
{
    if (stress_.valid())
    {
        stress_->addDiffusion(UEqn);
        if (law_)
        {
            stress_->addTransposed(gradient_(), UEqn);
        }
        else
        {
            stress_->addTransposed(UEqn);
        }
    }
}


Foam::scalarField Foam::fsi::fluidViscosity::smaller() const
{
    const scalar nu = objects_.fluid().viscosity;
    scalarField result(geometry_.grid().mesh().nCells(), nu);
    if (law_)
    {
        result = around_;
    }
    if (more_.valid())
    {
        result += min(more_->primitiveField() - (result - nu), scalar(0));
    }
    return result;
}


// ************************************************************************* //
