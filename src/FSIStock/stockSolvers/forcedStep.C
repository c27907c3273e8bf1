// SPDX-License-Identifier: GPL-3.0-or-later

#include "forcedStep.H"
#include "dictionaryCheck.H"
#include "sumOverRanks.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(forcedStep, 0);

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

Foam::fsi::forcedStep::forcedStep
(
    fsiObjects& objects,
    const volVectorField& U,
    const dictionary& dict
)
:
    fsiStep(objects),
    U_(U),
    strength_(readPositive(dict, "strength", 1000)),
    virtualMass_(readNonNegative(dict, "virtualMass", 1)),
    coverage_
    (
        objects.grid(), max(label(readPositive(dict, "samples", 4)), 1)
    ),
    coefficientField_
    (
        IOobject
        (
            "forcingCoefficient",
            nameOf(objects.grid().mesh().time()),
            objects.grid().mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        objects.grid().mesh(),
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    renewed_(true)
{
    readChoice(dict, "type", typeName, {typeName});
    checkKeys(dict, {"type", "strength", "virtualMass", "samples"});
    objects.bodies().layout().zero(lag_);
    renew();
    renewed_ = !readState();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::forcedStep::groupNodal
Foam::fsi::forcedStep::objectVelocities() const
{
    const PtrList<bodyGroup>& groups = objects_.bodies().groups();
    groupNodal velocities(groups.size());
    forAll(groups, groupi)
    {
        velocities[groupi] = groups[groupi].velocities();
    }
    return velocities;
}


Foam::fsi::forcedStep::groupNodal
Foam::fsi::forcedStep::lag(const vectorField& U) const
{
    const UList<label>& cells = coverage_.cells();
    const scalarField mass
    (
        objects_.fluid().density*coverage_.fractions()
       *scalarField(objects_.grid().mesh().V(), cells)
    );
    vectorField momentum(cells.size());
    forAll(cells, i)
    {
        momentum[i] = mass[i]*(U[cells[i]] - cellVelocity_[i]);
    }
    return nodesOf(momentum);
}


Foam::fsi::forcedStep::groupNodal
Foam::fsi::forcedStep::nodesOf(const vectorField& values) const
{
    groupNodal nodal;
    objects_.bodies().layout().zero(nodal);
    coverage_.spread(values, nodal);
    for (Eigen::MatrixXd& ofGroup : nodal)
    {
        sumOverRanks(ofGroup);
    }
    return nodal;
}


void Foam::fsi::forcedStep::setHydrodynamicForce()
{
    const population& objects = objects_.bodies();
    const direction nDims = objects_.grid().nDims();
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


void Foam::fsi::forcedStep::takeLoad(const vectorField& U)
{
    const scalar dt0 = objects_.grid().mesh().time().deltaT0Value();
    const scalar rho = objects_.fluid().density;
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
        const bodyGroup& group = objects_.bodies().groups()[groupi];
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


void Foam::fsi::forcedStep::takeObjects(const vectorField& U)
{
    if (renewed_)
    {
        renewed_ = false;
        updateCoverage();
        lag_ = lag(U);
    }
}


void Foam::fsi::forcedStep::updateCoverage()
{
    coverage_.update(objects_.bodies());
    cellVelocity_ = coverage_.interpolate(objectVelocities());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::forcedStep::advance(const flowSources&)
{
    const scalar dt = objects_.deltaT();
    const stepLength step{dt, dt};
    const vectorField& last = U_.oldTime().primitiveField();

    takeLoad(last);
    if (feed())
    {
        renew();
    }
    objects_.drive(U_.oldTime());
    groupNodal force(objects_.forces(step));
    nodeLayout::add(load_, force);
    predictAlone(force, step);
    takeObjects(last);
    objects_.limit(velocity_, step);
    objects_.move(velocity_.groups(), step);
    objects_.moveLevelSet({});
    updateCoverage();
    if (U_.time().writeTime())
    {
        writeState();
    }
}


void Foam::fsi::forcedStep::force(fvVectorMatrix& UEqn)
{
    const UList<label>& cells = coverage_.cells();
    const scalarField fractions(coverage_.fractions());
    coefficient_.setSize(cells.size());
    coefficientField_.primitiveFieldRef() = Zero;
    const scalar V = objects_.grid().cellVolume();

    // With the parts of the patches: those between ranks count as faces inside
    const scalarField diagonal(UEqn.D());
    forAll(cells, i)
    {
        const label celli = cells[i];
        coefficient_[i] =
            diagonal[celli]*fractions[i]
           /(1 - fractions[i] + 1/strength_);
        UEqn.diag()[celli] += coefficient_[i];
        UEqn.source()[celli] += coefficient_[i]*cellVelocity_[i];
        coefficientField_[celli] = coefficient_[i]/V;
    }
}


// ************************************************************************* //
