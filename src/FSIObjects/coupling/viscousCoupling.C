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
    if (!Pstream::parRun())
    {
        return;
    }

    List<scalarList> ranks(Pstream::nProcs());
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
    ranks[Pstream::myProcNo()] = packed;
    Pstream::gatherList(ranks);
    Pstream::scatterList(ranks);

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
    matrix_(system.grid)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::updateResponses
(
    const fsiSystem::groupNodal& predicted
)
{
    const population& objects = system_.objects;
    const labelList& start = objects.surfaces().pointStart();
    const scalar viscosity = system_.fluidDensity*system_.viscosity;

    std::vector<std::vector<copyLink>> links(objects.size());
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
        links[objecti].push_back(c);
    }
    gatherLinks(links);
    addShortWaves(system_, links);

    fsiSystem::groupNodal turning;
    transposedModes(system_, turning);
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
        const auto first = links.begin() + objects.objectIndex(groupi, 0);
        responses_[groupi]->update
        (
            system_.deltaT(),
            {first, first + group.size()},
            turning[groupi],
            predicted[groupi]
        );
    }
}


void Foam::fsi::viscousCoupling::nodeVelocity(fsiSystem::groupNodal& v)
{
    const scalar viscosity = system_.fluidDensity*system_.viscosity;
    const direction nDims = system_.grid.nDims();

    nodal_.setSize(system_.objects.surfaces().points().size());
    nodal_ = Zero;
    for (const wallLink& link : system_.geometry.wallLinks())
    {
        vector value(Zero);
        for (direction d = 0; d < nDims; ++d)
        {
            value[d] =
                viscosity*link.conductance*matrix_.value(link.cell, d);
        }
        link.place.spread(nodal_, value);
    }
    sumOverRanks(nodal_);
    if (system_.transposedStress == fsiSystem::transposedPart::linear)
    {
        addTransposedForce(system_, nodalVelocity_, nodal_);
    }
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


void Foam::fsi::viscousCoupling::moveWalls(const fsiSystem::groupNodal& v)
{
    const direction nDims = system_.grid.nDims();
    const UList<wallLink>& links = system_.geometry.wallLinks();

    // A cell may have several links
    system_.fromBoundary(v, nodalVelocity_);
    forAll(links, i)
    {
        for (direction d = 0; d < nDims; ++d)
        {
            matrix_.source(links[i].cell, d) = linkSource_[i][d];
        }
    }
    for (const wallLink& link : links)
    {
        const vector wall(link.place.interpolate(nodalVelocity_));
        for (direction d = 0; d < nDims; ++d)
        {
            matrix_.source(link.cell, d) +=
                system_.viscosity*link.conductance*wall[d];
        }
    }
}


void Foam::fsi::viscousCoupling::setMatrix(const fvVectorMatrix& UEqn)
{
    const UList<wallLink>& links = system_.geometry.wallLinks();
    matrix_.set(UEqn);
    linkSource_.setSize(links.size());
    forAll(links, i)
    {
        const label celli = links[i].cell;
        matrix_.addToDiagonal
        (
            celli,
            system_.viscosity*links[i].conductance
        );
        for (direction d = 0; d < system_.grid.nDims(); ++d)
        {
            linkSource_[i][d] = matrix_.source(celli, d);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
