// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactPatches.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Least cosine between the normals of a patch
static const scalar sameSide = 0.5;

//- Normal of a pair, from the one of its two objects to the other that has the
//  larger label
static vector orientedNormal
(
    const contactProblem& problem,
    const contactPair& pair
)
{
    const label own = problem.surfaces.pointObject()[pair.node];
    return own > pair.other ? pair.normal : -pair.normal;
}


//- Have two pairs the same two objects?
static bool sameObjects
(
    const contactProblem& problem,
    const contactPair& a,
    const contactPair& b
)
{
    const label ownA = problem.surfaces.pointObject()[a.node];
    const label ownB = problem.surfaces.pointObject()[b.node];
    return
        (ownA == ownB && a.other == b.other)
     || (ownA == b.other && a.other == ownB);
}


//- Largest difference between the velocities of the pairs of a patch and its
//  own velocity u, at the start of the step [m/s]
static scalar spread
(
    const contactProblem& problem,
    const std::vector<std::pair<label, scalar>>& pairs,
    const scalar u
)
{
    const vectorField& v = problem.surfaces.velocities();
    scalar most = 0;
    for (const auto& p : pairs)
    {
        const contactPair& pair = problem.found.pairs[p.first];
        most = max(most, mag(problem.normalVelocity(pair, v) - u));
    }
    return most;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactPatches::patch::relax
(
    const scalar velocity,
    const contactProblem& problem
)
{
    const contactStep& step = problem.step;
    const scalar free = velocity - compliance_*impulse_;
    const scalar floor = min((problem.touching - gap_)/step.tau, scalar(0));
    if (!visited_)
    {
        visited_ = true;
        // In a step of second order bodies turn, and normal velocities are
        // known to their change in the step only
        const scalar after = free + still_;
        const scalar speed =
            min(-before_, -after)
          - (step.tau != step.dt ? mag(after - before_) : 0);
        // Below the spread it is the speed of facets that roll
        const scalar back = step.rebound*(speed - loss_) - loss_;
        least_ =
            back > 0 && speed > spread(problem, pairs_, before_)
          ? max(back - still_, floor)
          : floor;
    }
    // Once they touch they do so until the sweeps end, or these might not end
    touches_ = touches_ || free < floor;
    const scalar last = impulse_;
    impulse_ = touches_ ? max((least_ - free)/compliance_, scalar(0)) : 0;
    return impulse_ - last;
}


void Foam::fsi::contactPatches::setStart
(
    const contactProblem& problem,
    patch& p
)
{
    const vectorField& v = problem.surfaces.velocities();
    for (auto& each : p.pairs_)
    {
        const contactPair& pair = problem.found.pairs[each.first];
        each.second /= p.second_;
        const scalar before = problem.normalVelocity(pair, v);
        p.before_ += each.second*before;
        if (problem.step.start)
        {
            const scalar moves =
                problem.normalVelocity(pair, *problem.step.start);
            p.still_ += each.second*(before - moves);
        }
    }
}


Foam::scalar Foam::fsi::contactPatches::complianceOf
(
    const contactProblem& problem,
    const sharedEdges& shared,
    const patch& p,
    const bool withFluid
)
{
    const auto part = [&](const label objecti)
    {
        return
            withFluid && objecti >= 0
          ? 1/(1 + problem.bodies[objecti].addedMass)
          : 1.0;
    };
    const surfaceSet& surfaces = problem.surfaces;
    const UList<contactPair>& pairs = problem.found.pairs;
    const contactPair& first = pairs[p.pairs_[0].first];
    scalar sum = 0;
    const label own = surfaces.pointObject()[first.node];
    for (const label objecti : {own, first.other})
    {
        const label nModes = objecti < 0 ? 0 : problem.bodies[objecti].nModes;
        for (label k = 0; k < nModes; ++k)
        {
            scalar share = 0;
            for (const auto& each : p.pairs_)
            {
                const contactPair& pair = pairs[each.first];
                share +=
                    each.second
                   *problem.bodies.share(surfaces, objecti, pair, k);
            }
            sum +=
                part(objecti)*problem.bodies[objecti].coefficients[k]
               *sqr(share);
        }
    }
    if (!problem.exchange)
    {
        return sum;
    }
    const scalar guest = part(problem.bodies[own].guest ? own : first.other);
    for (const auto& a : p.pairs_)
    {
        for (const auto& b : p.pairs_)
        {
            sum +=
                guest*a.second*b.second*shared.response(a.first, b.first);
        }
    }
    return sum;
}


void Foam::fsi::contactPatches::setLoss
(
    const contactProblem& problem,
    const sharedEdges& shared,
    patch& p
)
{
    const contactFilm& film = problem.step.film;
    if (film.below(problem.touching))
    {
        const label nDims = problem.surfaces.nDims();
        const scalar radius =
            film.radius(p.second_, p.third_, problem.patchDepth, nDims);
        p.loss_ =
            film.impulse(radius, problem.touching, nDims)
           *complianceOf(problem, shared, p, true);
    }
}


void Foam::fsi::contactPatches::addPatches
(
    const contactProblem& problem,
    const UList<label>& members
)
{
    const UList<contactPair>& pairs = problem.found.pairs;
    for (const label firsti : members)
    {
        if (of_[firsti] != none)
        {
            continue;
        }
        const contactPair& first = pairs[firsti];
        const vector normal(orientedNormal(problem, first));
        patch p;
        p.gap_ = first.gap;
        for (const label pairi : members)
        {
            const contactPair& pair = pairs[pairi];
            if
            (
                of_[pairi] != none
             || !sameObjects(problem, first, pair)
             || (orientedNormal(problem, pair) & normal) < sameSide
            )
            {
                continue;
            }
            of_[pairi] = follows;
            const scalar part = 1 - (pair.gap - first.gap)/problem.patchDepth;
            if (part > 0)
            {
                const scalar weight = problem.area(pair)*sqr(part);
                p.pairs_.push_back({pairi, weight});
                p.second_ += weight;
                p.third_ += part*weight;
            }
        }
        of_[firsti] = patches_.size();
        setStart(problem, p);
        patches_.push_back(p);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactPatches::set
(
    const contactProblem& problem,
    const contactOrder& order,
    const sharedEdges& shared
)
{
    const UList<contactPair>& pairs = problem.found.pairs;
    patches_.clear();
    of_.setSize(pairs.size());
    of_ = none;
    if (problem.touching <= 0)
    {
        return;
    }
    DynamicList<label> members;
    for (const contactOrder::edge& e : order.edges())
    {
        members.clear();
        for (label i = e.first; i < e.end; ++i)
        {
            const label pairi = order.pairs()[i];
            if (pairs[pairi].component < 0 && problem.rigid(pairs[pairi]))
            {
                members.append(pairi);
            }
        }
        std::stable_sort
        (
            members.begin(),
            members.end(),
            [&](const label a, const label b)
            {
                return pairs[a].gap < pairs[b].gap;
            }
        );
        addPatches(problem, members);
    }
    for (patch& p : patches_)
    {
        p.compliance_ = complianceOf(problem, shared, p, false);
        setLoss(problem, shared, p);
    }
}


// ************************************************************************* //
