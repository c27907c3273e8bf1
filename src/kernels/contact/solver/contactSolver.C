// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactSolver.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contactSolver::contactSolver(const dictionary& dict)
:
    tolerance_(readPositive(dict, "tolerance", 1e-4)),
    maxSweeps_(readBetween(dict, "maxSweeps", 100, 1, 1000000)),
    friction_(dict)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactSolver::sweep
(
    const contactProblem& problem,
    const contactRule& rule,
    const bool all,
    const bool backward
)
{
    if (problem.exchange)
    {
        return sharedSweep(problem, rule, all, backward);
    }
    const labelUList& pairs = all ? order_.pairs() : active_;
    const label n = pairs.size();
    scalar change = 0;
    for (label i = 0; i < n; ++i)
    {
        const label j = backward ? n - 1 - i : i;
        change = max(change, relax(problem, rule, pairs[j]));
    }
    return change;
}


Foam::scalar Foam::fsi::contactSolver::sharedSweep
(
    const contactProblem& problem,
    const contactRule& rule,
    const bool all,
    const bool backward
)
{
    boolList visited(impulses_.size(), all);
    for (label i = 0; i < active_.size() && !all; ++i)
    {
        visited[active_[i]] = true;
    }
    const label nColours = order_.nColours();
    scalar change = 0;
    for (label i = 0; i < nColours; ++i)
    {
        const label colour = backward ? nColours - 1 - i : i;
        const label first = order_.starts()[colour];
        const label n = order_.starts()[colour + 1] - first;
        shared_.begin(colour, response_);
        for (label k = 0; k < n; ++k)
        {
            const label pairi =
                order_.pairs()[first + (backward ? n - 1 - k : k)];
            if (visited[pairi] && !shared_.elsewhere(pairi))
            {
                change = max(change, relax(problem, rule, pairi));
            }
        }
        shared_.end(colour, response_, impulses_);
    }
    return problem.exchange->largest(change);
}


void Foam::fsi::contactSolver::reset(const contactProblem& problem)
{
    const label nPairs = problem.found.pairs.size();

    response_.reset
    (
        problem.surfaces,
        problem.velocities,
        problem.bodies,
        problem.found.pairs
    );
    order_.set
    (
        problem.surfaces,
        problem.bodies,
        problem.found.pairs,
        problem.exchange
    );
    if (problem.exchange)
    {
        shared_.set(problem, order_);
    }
    compliances_.setSize(nPairs);
    startGaps_.setSize(nPairs);
    endGaps_.setSize(nPairs);
    endGaps_ = GREAT;
    addedVelocities_.setSize(nPairs);
    impulses_.setSize(nPairs);
    impulses_ = 0;
    ruleImpulses_.setSize(nPairs);
    ruleImpulses_ = 0;
    for (label i = 0; i < nPairs; ++i)
    {
        const contactPair& pair = problem.found.pairs[i];
        compliances_[i] =
            response_.compliance(i)
          + (problem.exchange ? shared_.compliance(i) : 0);
        startGaps_[i] = problem.startGap(pair);
        addedVelocities_[i] = problem.addedVelocity(pair);
    }
    patches_.set(problem, order_, shared_);
}


Foam::label Foam::fsi::contactSolver::sweeps
(
    const contactProblem& problem,
    const contactRule& rule
)
{
    reset(problem);

    bool all = true;
    for (label sweepi = 0; sweepi < maxSweeps_; ++sweepi)
    {
        const bool converged =
            sweep(problem, rule, all, sweepi % 2)
         <= tolerance_*problem.range;

        if (all && converged)
        {
            return sweepi + 1;
        }
        if (all)
        {
            active_.clear();
            for (const label i : order_.pairs())
            {
                if (impulses_[i] != 0 || endGaps_[i] < 1.2*problem.range)
                {
                    active_.append(i);
                }
            }
        }
        all = converged;
    }
    return maxSweeps_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::contactSolver::solve
(
    const contactProblem& problem,
    const contactRule& rule
)
{
    if (!friction_.active())
    {
        return sweeps(problem, rule);
    }
    friction_.set(problem);
    return sweeps(friction_.with(problem), rule);
}


void Foam::fsi::contactSolver::addForces
(
    const contactProblem& problem,
    vectorField& force
) const
{
    const contactProblem whole
    (
        friction_.active() ? friction_.with(problem) : problem
    );
    for (const label pairi : order_.pairs())
    {
        const contactPair& pair = whole.found.pairs[pairi];
        const scalar size = impulses_[pairi]/problem.step.tau;
        const vector f(size*pair.normal);

        force[pair.node] += f;
        if (pair.face >= 0)
        {
            const surfaceFace& face = problem.surfaces.faces()[pair.face];
            for (label i = 0; i < problem.surfaces.nNodes(); ++i)
            {
                force[face[i]] -= pair.weights[i]*f;
                force[face[i]] -=
                    pair.couple ? size*(*pair.couple)[i] : vector(Zero);
            }
        }
    }
}


// ************************************************************************* //
