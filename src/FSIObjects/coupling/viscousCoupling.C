// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"
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
            for (label i = 0; i < 3; ++i)
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

    for (const scalarList& values : ranks)
    {
        for (label start = 0; start < values.size(); start += 8)
        {
            copyLink link;
            link.coefficient = values[start + 1];
            for (label i = 0; i < 3; ++i)
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
    UEqn_(nullptr)
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
        copyLink c{link.place.nodes, link.place.weights, 0};
        c.coefficient = viscosity*link.conductance;
        for (label& nodei : c.nodes)
        {
            nodei = nodei < 0 ? -1 : nodei - start[objecti];
        }
        links[objecti].push_back(c);
    }
    gatherLinks(links);

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
            responses_[groupi] = std::make_unique<viscousResponse>(group);
        }
        const auto first = links.begin() + objects.objectIndex(groupi, 0);
        responses_[groupi]->update
        (
            system_.deltaT(),
            viscosity*system_.grid.thickness(),
            {first, first + group.size()},
            predicted[groupi]
        );
    }
}


void Foam::fsi::viscousCoupling::nodeVelocity
(
    const components& u,
    const bool withSource,
    fsiSystem::groupNodal& v
) const
{
    const scalar viscosity = system_.fluidDensity*system_.viscosity;

    nodal_.setSize(system_.objects.surfaces().points().size());
    nodal_ = Zero;
    for (const wallLink& link : system_.geometry.wallLinks())
    {
        vector value(Zero);
        forAll(u, d)
        {
            value[d] = viscosity*link.conductance*u[d][link.cell];
        }
        link.place.spread(nodal_, value);
    }
    sumOverRanks(nodal_);

    system_.objects.toGroups(nodal_, groupForce_);
    forAll(v, groupi)
    {
        if (responses_[groupi])
        {
            responses_[groupi]->solve
            (
                groupForce_[groupi],
                v[groupi],
                withSource
            );
        }
        else if (!withSource)
        {
            v[groupi].setZero
            (
                groupForce_[groupi].rows(),
                groupForce_[groupi].cols()
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::solve
(
    fvVectorMatrix& UEqn,
    volVectorField& U,
    const fsiSystem::groupNodal& predicted,
    fsiSystem::groupNodal& velocity,
    vectorField& force
)
{
    UEqn_ = &UEqn;
    updateResponses(predicted);

    components source;
    setMatrix(source);
    components u(source.size());
    forAll(u, d)
    {
        u[d] = U.primitiveField().component(d);
    }

    // Velocity of the nodes without the fluid moves the walls
    velocity = predicted;
    components still(u.size(), scalarField(U.size(), Zero));
    nodeVelocity(still, true, velocity);
    system_.objects.toSurface(velocity, nodalVelocity_);
    for (const wallLink& link : system_.geometry.wallLinks())
    {
        const vector wall(link.place.interpolate(nodalVelocity_));
        forAll(source, d)
        {
            source[d][link.cell] +=
                system_.viscosity*link.conductance*wall[d];
        }
    }

    scalar initialResidual = 0;
    scalar finalResidual = 0;
    const label nIterations = iterate
    (
        u,
        source,
        U.mesh().solverDict(U.name()),
        initialResidual,
        finalResidual
    );
    Info<< "fsiBiCGStab:  Solving for " << U.name() << ", Initial residual = "
        << initialResidual << ", Final residual = " << finalResidual
        << ", No Iterations " << nIterations << endl;

    forAll(u, d)
    {
        U.primitiveFieldRef().replace(d, u[d]);
    }
    U.correctBoundaryConditions();

    nodeVelocity(u, true, velocity);
    system_.objects.toSurface(velocity, nodalVelocity_);
    force.setSize(nodalVelocity_.size());
    force = Zero;
    addLinkForce(system_, U, nodalVelocity_, force);
    sumOverRanks(force);
    UEqn_ = nullptr;
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


void Foam::fsi::addTransposedForce
(
    const fsiSystem& system,
    const vectorField& v,
    vectorField& force
)
{
    const scalar viscosity =
        system.fluidDensity*system.viscosity*system.grid.thickness();
    for (const surfaceFace& face : system.objects.surfaces().faces())
    {
        const vector d = v[face[1]] - v[face[0]];
        const vector half = 0.5*viscosity*vector(-d.y(), d.x(), 0);
        force[face[0]] += half;
        force[face[1]] += half;
    }
}


// ************************************************************************* //
