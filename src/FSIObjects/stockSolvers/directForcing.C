// SPDX-License-Identifier: GPL-3.0-or-later

#include "directForcing.H"
#include "dictionaryCheck.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(directForcing, 0);

    //- Replace a matrix by its sum over all ranks
    static void sumOverRanks(Eigen::MatrixXd& matrix)
    {
        List<scalar> values(label(matrix.size()));
        std::copy_n(matrix.data(), matrix.size(), values.begin());
        sumOverRanks(values);
        std::copy_n(values.cbegin(), matrix.size(), matrix.data());
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::directForcing::directForcing
(
    fsiSystem& system,
    stepTimer& timer,
    const dictionary& dict
)
:
    noFluid(system, timer, dictionary::null),
    strength_(readPositive(dict, "strength", 1000)),
    virtualMass_(readNonNegative(dict, "virtualMass", 1)),
    coverage_(system.grid, max(label(readPositive(dict, "samples", 4)), 1)),
    coefficientField_
    (
        IOobject
        (
            "forcingCoefficient",
            nameOf(system.grid.mesh().time()),
            system.grid.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        system.grid.mesh(),
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    renewed_(true)
{
    checkKeys(dict, {"type", "strength", "virtualMass", "samples"});
    system.objects.layout().zero(lag_);
    renew();
    renewed_ = !read();
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::couplingModel> Foam::fsi::directForcing::select
(
    fsiSystem& system,
    stepTimer& timer
)
{
    const dictionary& dict = system.properties.subOrEmptyDict("coupling");
    readChoice(dict, "type", typeName, {typeName});
    return autoPtr<couplingModel>(new directForcing(system, timer, dict));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::directForcing::groupNodal
Foam::fsi::directForcing::objectVelocities() const
{
    const PtrList<bodyGroup>& groups = system_.objects.groups();
    groupNodal velocities(groups.size());
    forAll(groups, groupi)
    {
        velocities[groupi] = groups[groupi].velocities();
    }
    return velocities;
}


Foam::fsi::directForcing::groupNodal
Foam::fsi::directForcing::lag(const vectorField& U) const
{
    const UList<label>& cells = coverage_.cells();
    const scalarField mass
    (
        system_.fluidDensity*coverage_.fractions()
       *scalarField(system_.grid.mesh().V(), cells)
    );
    vectorField momentum(cells.size());
    forAll(cells, i)
    {
        momentum[i] = mass[i]*(U[cells[i]] - cellVelocity_[i]);
    }
    return nodesOf(momentum);
}


Foam::fsi::directForcing::groupNodal
Foam::fsi::directForcing::nodesOf(const vectorField& values) const
{
    groupNodal nodal;
    system_.objects.layout().zero(nodal);
    coverage_.spread(values, nodal);
    for (Eigen::MatrixXd& ofGroup : nodal)
    {
        sumOverRanks(ofGroup);
    }
    return nodal;
}


void Foam::fsi::directForcing::setHydrodynamicForce()
{
    const population& objects = system_.objects;
    const direction nDims = system_.grid.nDims();
    const labelList& start = objects.surfaces().pointStart();

    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        const Eigen::MatrixXd& load = load_[objects.objectGroup(objecti)];
        vector total(Zero);
        for (direction d = 0; d < nDims; ++d)
        {
            total[d] = load.col(nDims*objects.objectCopy(objecti) + d).sum();
        }
        const label nNodes = start[objecti + 1] - start[objecti];
        SubField<vector>(hydrodynamicForce_, nNodes, start[objecti]) =
            total/nNodes;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::directForcing::takeLoad(const vectorField& U)
{
    const scalar dt0 = system_.grid.mesh().time().deltaT0Value();
    const scalar rho = system_.fluidDensity;
    const UList<label>& cells = coverage_.cells();

    vectorField reaction(cells.size());
    forAll(cells, i)
    {
        reaction[i] = rho*coefficient_[i]*(U[cells[i]] - cellVelocity_[i]);
    }
    groupNodal load(nodesOf(reaction));
    const groupNodal newLag(lag(U));

    forAll(load, groupi)
    {
        const bodyGroup& group = system_.objects.groups()[groupi];
        const shapeTemplate& shape = group.shape();
        const scalar density = shape.density();
        const scalar omega = density/(density + virtualMass_*rho);

        load[groupi] += (newLag[groupi] - lag_[groupi])/dt0;
        const scalar inertia = rho/(density*dt0);
        for (Eigen::Index nodei = 0; nodei < load[groupi].rows(); ++nodei)
        {
            load[groupi].row(nodei) +=
                inertia*shape.nodeMasses()[label(nodei)]
               *(
                    group.velocities().row(nodei)
                  - lastVelocity_[groupi].row(nodei)
                );
        }
        load_[groupi] += omega*(load[groupi] - load_[groupi]);
    }
    lag_ = newLag;
    lastVelocity_ = objectVelocities();
    setHydrodynamicForce();
}


void Foam::fsi::directForcing::takeObjects(const vectorField& U)
{
    if (renewed_)
    {
        renewed_ = false;
        updateCoverage();
        lag_ = lag(U);
    }
}


void Foam::fsi::directForcing::begin
(
    const groupNodal& force,
    const volScalarField& p
)
{
    groupNodal total(force);
    forAll(total, groupi)
    {
        total[groupi] += load_[groupi];
    }
    noFluid::begin(total, p);
}


void Foam::fsi::directForcing::end
(
    const volScalarField&,
    const volVectorField&
)
{
    limitContact(velocity_);
}


void Foam::fsi::directForcing::updateCoverage()
{
    coverage_.update(system_.objects);
    cellVelocity_ = coverage_.interpolate(objectVelocities());
}


void Foam::fsi::directForcing::force(fvVectorMatrix& UEqn)
{
    const UList<label>& cells = coverage_.cells();
    const scalarField fractions(coverage_.fractions());
    coefficient_.setSize(cells.size());
    coefficientField_.primitiveFieldRef() = Zero;
    const scalar V = system_.grid.faceArea()*system_.grid.spacing();
    forAll(cells, i)
    {
        const label celli = cells[i];
        coefficient_[i] =
            UEqn.diag()[celli]*fractions[i]
           /(1 - fractions[i] + 1/strength_);
        UEqn.diag()[celli] += coefficient_[i];
        UEqn.source()[celli] += coefficient_[i]*cellVelocity_[i];
        coefficientField_[celli] = coefficient_[i]/V;
    }
}


// ************************************************************************* //
