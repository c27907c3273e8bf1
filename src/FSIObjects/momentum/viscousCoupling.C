// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"
#include "linkForces.H"
#include "shortWaveStress.H"
#include "solverPerformance.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::viscousCoupling::viscousCoupling(const fsiSystem& system)
:
    system_(system),
    matrix_(system.grid),
    links_(matrix_, system.grid.nDims())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::updateTransposedStress()
{
    transposed_.clear();
    std::vector<transposedMode> strains;
    for (transposedMode& mode : transposedModes(system_))
    {
        (mode.sign > 0 ? transposed_ : strains).push_back(std::move(mode));
    }

    const surfaceSet& surfaces = system_.objects.surfaces();
    strainForce_.setSize(surfaces.points().size());
    strainForce_ = Zero;
    addTransposedForce
    (
        strains,
        surfaces.pointStart(),
        surfaces.velocities(),
        strainForce_
    );
}


void Foam::fsi::viscousCoupling::updateResponses
(
    const fsiSystem::groupNodal& predicted
)
{
    const population& objects = system_.objects;
    setCopyLinks(system_, copyLinks_);
    addShortWaves(system_, copyLinks_);

    updateTransposedStress();
    List<std::vector<Eigen::MatrixXd>> resisting(objects.groups().size());
    fsiSystem::groupNodal nodal;
    for (const transposedMode& mode : transposed_)
    {
        system_.objects.layout().toBoundary(mode.vectors, nodal);
        forAll(nodal, groupi)
        {
            resisting[groupi].push_back(nodal[groupi]);
        }
    }
    responses_.resize(objects.groups().size());
    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        if (!group.movesFreely())
        {
            continue;
        }
        if (!responses_[groupi])
        {
            responses_[groupi] = viscousResponse::New(group);
        }
        responses_[groupi]->update
        (
            system_.stepTime(),
            copyLinks_.data() + objects.objectIndex(groupi, 0),
            resisting[groupi],
            predicted[groupi]
        );
    }
}


void Foam::fsi::viscousCoupling::nodeVelocity(fsiSystem::groupNodal& v)
{
    nodal_.setSize(system_.objects.surfaces().points().size());
    nodal_ = Zero;
    links_.addForce(system_.fluidDensity, nodal_);
    sumOverRanks(nodal_);
    nodal_ += strainForce_;
    system_.objects.layout().toBoundary(nodal_, groupForce_);
    forAll(v, groupi)
    {
        if (responses_[groupi])
        {
            responses_[groupi]->solve(groupForce_[groupi], v[groupi]);
        }
    }
}


void Foam::fsi::viscousCoupling::overRelax(fsiSystem::groupNodal& v)
{
    const scalar further = max(relaxation_.factor() - 1, 0.0);
    lastVelocity_ = v;
    nodeVelocity(v);
    forAll(v, groupi)
    {
        v[groupi] += further*(v[groupi] - lastVelocity_[groupi]);
    }
}


void Foam::fsi::viscousCoupling::setWalls(const fsiSystem::groupNodal& v)
{
    system_.objects.layout().toSurface(v, nodalVelocity_);
    links_.setSources(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::startCorrection(const scalar norm)
{
    matrix_.startCorrection(norm);
    links_.startCorrection(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::moveWalls(const fsiSystem::groupNodal& v)
{
    system_.objects.layout().toSurface(v, nodalVelocity_);
    links_.setResiduals(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::setMatrix
(
    const fvVectorMatrix& UEqn,
    const expectedChange& change
)
{
    matrix_.set(UEqn, change);
    links_.set(system_.geometry.wallLinks(), system_.viscosity);
}


// ************************************************************************* //
