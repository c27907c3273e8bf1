// SPDX-License-Identifier: GPL-3.0-or-later

#include "sharedEdges.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::sharedEdges::setEdges
(
    const contactProblem& problem,
    const contactOrder& order
)
{
    const UList<contactPair>& pairs = problem.found.pairs;
    const surfaceSet& surfaces = problem.surfaces;
    edges_.clear();
    for (const contactOrder::edge& e : order.edges())
    {
        if
        (
            e.low < 0
         || problem.bodies[e.low].guest == problem.bodies[e.high].guest
        )
        {
            continue;
        }
        const bool solved = !problem.bodies[e.low].guest;
        edge shared;
        shared.ids =
            labelPair(problem.bodies[e.low].id, problem.bodies[e.high].id);
        shared.rank = exchange_->owner(solved ? e.high : e.low);
        shared.colour = e.colour;
        shared.solved = solved;
        shared.object = solved ? e.low : e.high;
        shared.pairs = SubList<label>(order.pairs(), e.end - e.first, e.first);
        const auto place = [&](const label pairi)
        {
            const contactPair& pair = pairs[pairi];
            const label own = surfaces.pointObject()[pair.node];
            return std::make_tuple
            (
                own == e.high,
                pair.node - surfaces.pointStart()[own],
                pair.gap,
                pair.component
            );
        };
        std::sort
        (
            shared.pairs.begin(),
            shared.pairs.end(),
            [&](const label a, const label b) { return place(a) < place(b); }
        );
        edges_.push_back(shared);
    }
    std::sort
    (
        edges_.begin(),
        edges_.end(),
        [](const edge& a, const edge& b) { return a.ids < b.ids; }
    );

    edgeOf_.setSize(pairs.size());
    edgeOf_ = -1;
    placeOf_.setSize(pairs.size());
    for (std::size_t edgei = 0; edgei < edges_.size(); ++edgei)
    {
        forAll(edges_[edgei].pairs, i)
        {
            edgeOf_[edges_[edgei].pairs[i]] = edgei;
            placeOf_[edges_[edgei].pairs[i]] = i;
        }
    }
}


void Foam::fsi::sharedEdges::setResponses(const contactProblem& problem)
{
    List<DynamicList<scalar>> sent(exchange_->nRanks());
    for (const edge& e : edges_)
    {
        for (label q = 0; q < e.pairs.size() && !e.solved; ++q)
        {
            for (const label pairi : e.pairs)
            {
                sent[e.rank].append
                (
                    problem.bodies.coupling
                    (
                        problem.surfaces,
                        e.object,
                        problem.found.pairs[pairi],
                        problem.found.pairs[e.pairs[q]]
                    )
                );
            }
        }
    }

    // Messages of the same pairs follow, whose sizes are not told any more
    const List<scalarList> received(exchange_->swap(sent));
    labelList next(received.size(), Zero);
    for (edge& e : edges_)
    {
        if (e.solved)
        {
            const label n = e.pairs.size();
            if (next[e.rank] + n*n > received[e.rank].size())
            {
                FatalErrorInFunction
                    << "Objects " << e.ids.first() << " and " << e.ids.second()
                    << ": their ranks have found other pairs"
                    << exit(FatalError);
            }
            e.response = Eigen::Map<const Eigen::MatrixXd>
            (
                received[e.rank].cdata() + next[e.rank], n, n
            );
            next[e.rank] += n*n;
        }
    }
}


template<class Number, class Take>
void Foam::fsi::sharedEdges::exchange
(
    const label colour,
    const bool solved,
    const Number& number,
    const Take& take
)
{
    List<DynamicList<scalar>> sent(exchange_->nRanks());
    labelList sizes(sent.size(), Zero);
    const auto forPairs = [&](const bool ofSolved, const auto& action)
    {
        for (const edge& e : edges_)
        {
            if (e.colour == colour && e.solved == ofSolved)
            {
                for (const label pairi : e.pairs)
                {
                    action(e.rank, pairi);
                }
            }
        }
    };
    forPairs(solved, [&](const label ranki, const label pairi)
    {
        sent[ranki].append(number(pairi));
    });
    forPairs(!solved, [&](const label ranki, const label)
    {
        ++sizes[ranki];
    });
    const List<scalarList> received(exchange_->swap(sent, sizes));
    labelList next(received.size(), Zero);
    forPairs(!solved, [&](const label ranki, const label pairi)
    {
        take(pairi, received[ranki][next[ranki]++]);
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::sharedEdges::set
(
    const contactProblem& problem,
    const contactOrder& order
)
{
    exchange_ = problem.exchange;
    setEdges(problem, order);
    setResponses(problem);
    velocities_.setSize(edgeOf_.size());
    velocities_ = Zero;
    changes_.setSize(edgeOf_.size());
    changes_ = Zero;
}


Foam::scalar Foam::fsi::sharedEdges::compliance(const label pairi) const
{
    const label edgei = edgeOf_[pairi];
    const label i = placeOf_[pairi];
    return
        edgei >= 0 && edges_[edgei].solved ? edges_[edgei].response(i, i) : 0;
}


void Foam::fsi::sharedEdges::addImpulse
(
    const label pairi,
    const scalar change
)
{
    if (edgeOf_[pairi] >= 0)
    {
        const edge& e = edges_[edgeOf_[pairi]];
        changes_[pairi] += change;
        forAll(e.pairs, i)
        {
            velocities_[e.pairs[i]] += e.response(i, placeOf_[pairi])*change;
        }
    }
}


void Foam::fsi::sharedEdges::begin
(
    const label colour,
    const contactResponse& response
)
{
    exchange
    (
        colour,
        false,
        [&](const label pairi) { return response.normalVelocity(pairi); },
        [&](const label pairi, const scalar velocity)
        {
            velocities_[pairi] = velocity;
            changes_[pairi] = 0;
        }
    );
}


void Foam::fsi::sharedEdges::end
(
    const label colour,
    contactResponse& response,
    scalarField& impulses
)
{
    exchange
    (
        colour,
        true,
        [&](const label pairi) { return changes_[pairi]; },
        [&](const label pairi, const scalar change)
        {
            response.addImpulse(pairi, change);
            impulses[pairi] += change;
        }
    );
}


// ************************************************************************* //
