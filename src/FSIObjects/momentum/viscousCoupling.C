// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"
#include "linkForces.H"
#include "shortWaveStress.H"
#include "solverPerformance.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::viscousCoupling::viscousCoupling
(
    const population& bodies,
    const interfaceGeometry& geometry,
    const fluidProperties& fluid,
    cartesianMultigrid& multigrid,
    runLog& log
)
:
    bodies_(bodies),
    geometry_(geometry),
    fluid_(fluid),
    log_(log),
    matrix_(geometry.grid()),
    multigrid_(geometry.grid(), multigrid),
    links_(matrix_, geometry.grid().nDims())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::updateResponses
(
    const stepLength& step,
    const nodeLayout::groupNodal& predicted
)
{
    setCopyLinks
    (
        bodies_, geometry_, fluid_.dynamicViscosity(), copyLinks_
    );
    if (fluid_.shearDependent())
    {
        relative_ = meanViscosities(bodies_, geometry_);
    }
    addShortWaves
    (
        bodies_, fluid_, geometry_.grid().thickness(), relative_, copyLinks_
    );

    setTransposedStress
    (
        bodies_, geometry_, fluid_, relative_, transposed_, strainForce_
    );
    List<std::vector<Eigen::MatrixXd>> resisting(bodies_.groups().size());
    nodeLayout::groupNodal nodal;
    for (const transposedMode& mode : transposed_)
    {
        bodies_.layout().toBoundary(mode.vectors, nodal);
        forAll(nodal, groupi)
        {
            resisting[groupi].push_back(nodal[groupi]);
        }
    }
    responses_.resize(bodies_.groups().size());
    forAll(bodies_.groups(), groupi)
    {
        const bodyGroup& group = bodies_.groups()[groupi];
        if (!group.movesFreely() || !group.hasWalls() || !group.size())
        {
            responses_[groupi].reset();
            continue;
        }
        if (!responses_[groupi])
        {
            responses_[groupi] = viscousResponse::New(group);
        }
        responses_[groupi]->update
        (
            step.tau,
            copyLinks_.data() + bodies_.objectIndex(groupi, 0),
            resisting[groupi],
            predicted[groupi]
        );
    }
}


void Foam::fsi::viscousCoupling::nodeVelocity(nodeLayout::groupNodal& v)
{
    nodal_.reset(bodies_.surfaces().points().size());
    links_.addForce(fluid_.density, nodal_);
    films_.addForce(fluid_.density, nodal_);
    nodal_.mine() += given_;
    vectorField& force = nodal_.collectWalls(bodies_.ranks());
    force += strainForce_;
    bodies_.layout().toBoundary(force, groupForce_);
    forAll(v, groupi)
    {
        if (responses_[groupi])
        {
            responses_[groupi]->solve(groupForce_[groupi], v[groupi]);
        }
    }
}


void Foam::fsi::viscousCoupling::overRelax(nodeLayout::groupNodal& v)
{
    const scalar further = max(relaxation_.factor() - 1, 0.0);
    lastVelocity_ = v;
    nodeVelocity(v);
    forAll(v, groupi)
    {
        v[groupi] += further*(v[groupi] - lastVelocity_[groupi]);
    }
}


void Foam::fsi::viscousCoupling::setNodes(const nodeLayout::groupNodal& v)
{
    bodies_.layout().wallsToSurface(v, nodalVelocity_);
}


void Foam::fsi::viscousCoupling::setWalls(const nodeLayout::groupNodal& v)
{
    setNodes(v);
    links_.setSources(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::startCorrection(const scalar norm)
{
    matrix_.startCorrection(norm);
    links_.startCorrection(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::moveWalls(const nodeLayout::groupNodal& v)
{
    setNodes(v);
    links_.setResiduals(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::setMatrix
(
    const fvVectorMatrix& UEqn,
    const expectedChange& change
)
{
    matrix_.set(UEqn, change);
    links_.set(geometry_.wallLinks(), fluid_.viscosity);
}


// ************************************************************************* //
