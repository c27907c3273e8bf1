// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"
#include "solverPerformance.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef viscousResponse::copyLink copyLink;

//- Give every rank the links of all ranks, in the order of the ranks
static void gatherLinks(std::vector<std::vector<copyLink>>& links)
{
    if (!severalRanks())
    {
        return;
    }

    DynamicList<scalar> packed;
    for (std::size_t objecti = 0; objecti < links.size(); ++objecti)
    {
        for (const copyLink& link : links[objecti])
        {
            packed.append(scalar(objecti));
            packed.append(link.coefficient);
            forAll(link.nodes, i)
            {
                packed.append(scalar(link.nodes[i]));
                packed.append(link.weights[i]);
            }
        }
        links[objecti].clear();
    }
    const List<scalarList> ranks(gatherOverRanks(scalarList(packed)));

    const label width = 2 + 2*copyLink().nodes.size();
    for (const scalarList& values : ranks)
    {
        for (label start = 0; start < values.size(); start += width)
        {
            copyLink link;
            link.coefficient = values[start + 1];
            forAll(link.nodes, i)
            {
                link.nodes[i] = label(round(values[start + 2 + 2*i]));
                link.weights[i] = values[start + 3 + 2*i];
            }
            links[std::size_t(round(values[start]))].push_back(link);
        }
    }
}

} // End namespace fsi
} // End namespace Foam


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
    transposed_ = transposedModes(system_);
    const std::vector<transposedMode> strains
    (
        transposed_.begin() + 1,
        transposed_.end()
    );
    transposed_.resize(1);

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
    const labelList& start = objects.surfaces().pointStart();
    const scalar viscosity = system_.fluidDensity*system_.viscosity;

    copyLinks_.resize(objects.size());
    for (auto& links : copyLinks_)
    {
        links.clear();
    }
    for (const wallLink& link : system_.geometry.wallLinks())
    {
        const label objecti = link.place.object;
        copyLink c;
        c.coefficient = viscosity*link.conductance;
        forAll(c.nodes, i)
        {
            const bool used =
                i < link.place.nodes.size() && link.place.nodes[i] >= 0;
            c.nodes[i] = used ? link.place.nodes[i] - start[objecti] : -1;
            c.weights[i] = used ? link.place.weights[i] : 0;
        }
        copyLinks_[objecti].push_back(c);
    }
    gatherLinks(copyLinks_);
    addShortWaves(system_, copyLinks_);

    updateTransposedStress();
    fsiSystem::groupNodal rotation;
    system_.toBoundary(transposed_.front().vectors, rotation);
    responses_.resize(objects.groups().size());
    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        if (!group.free())
        {
            continue;
        }
        if (!responses_[groupi])
        {
            responses_[groupi] = viscousResponse::New(group);
        }
        responses_[groupi]->update
        (
            system_.deltaT(),
            copyLinks_.data() + objects.objectIndex(groupi, 0),
            rotation[groupi],
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
    system_.toBoundary(nodal_, groupForce_);
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
    system_.fromBoundary(v, nodalVelocity_);
    links_.setSources(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::startCorrection(const scalar norm)
{
    matrix_.startCorrection(norm);
    links_.startCorrection(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::moveWalls(const fsiSystem::groupNodal& v)
{
    system_.fromBoundary(v, nodalVelocity_);
    links_.setResiduals(nodalVelocity_);
}


void Foam::fsi::viscousCoupling::setMatrix(const fvVectorMatrix& UEqn)
{
    matrix_.set(UEqn);
    links_.set(system_.geometry.wallLinks(), system_.viscosity);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addLinkForce
(
    const fsiSystem& system,
    const volVectorField& U,
    const vectorField& v,
    vectorField& force
)
{
    const scalar viscosity = system.fluidDensity*system.viscosity;
    for (const wallLink& link : system.geometry.wallLinks())
    {
        const vector slip(U[link.cell] - link.place.interpolate(v));
        link.place.spread(force, viscosity*link.conductance*slip);
    }
}


// ************************************************************************* //
