// SPDX-License-Identifier: GPL-3.0-or-later

#include "thesisContact.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(thesisContact, 0);
    addToRunTimeSelectionTable(contactLaw, thesisContact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::thesisContact::thesisContact
(
    const dictionary& dict,
    const contactScales& scales
)
:
    stiffness_(scales.stiffness(dict)),
    restLength_(readPositive(dict, "restLength", 2)*scales.range),
    cancel_(dict.lookupOrDefault<Switch>("cancel", true)),
    warned_(false)
{
    checkKeys(dict, {"type", "stiffness", "restLength", "cancel"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::thesisContact::collect(const contactProblem& problem)
{
    collisions_.clear();
    if (problem.found.nodePairs.size())
    {
        collisions_ = problem.found.nodePairs;
        return;
    }

    for (const contactPair& pair : problem.found.pairs)
    {
        if (pair.face < 0 || pair.gap > problem.range)
        {
            continue;
        }
        const surfaceFace& f = problem.surfaces.faces()[pair.face];
        for (label i = 0; i < problem.surfaces.nNodes(); ++i)
        {
            collisions_.append
            (
                labelPair(min(pair.node, f[i]), max(pair.node, f[i]))
            );
        }
    }
    std::sort(collisions_.begin(), collisions_.end());
    collisions_.resize
    (
        std::unique(collisions_.begin(), collisions_.end())
      - collisions_.begin()
    );
}


void Foam::fsi::thesisContact::repel
(
    const label nodei,
    const scalar area,
    const vector& offset
)
{
    ++count_[nodei];
    const scalar d = max(mag(offset), 1e-6*restLength_);
    if (d < restLength_)
    {
        repulsion_[nodei] +=
            stiffness_*area/restLength_*(restLength_ - d)/d*offset;
    }
}


Foam::scalar Foam::fsi::thesisContact::energy
(
    const scalar area,
    const scalar d
) const
{
    return 0.25*stiffness_*area/restLength_*sqr(max(restLength_ - d, 0.0));
}


void Foam::fsi::thesisContact::repelAll(const contactProblem& problem)
{
    const pointField& x = problem.surfaces.points();
    const scalarField& areas = problem.bodies.areas();

    repulsion_.setSize(x.size());
    repulsion_ = Zero;
    count_.setSize(x.size());
    count_ = 0;

    collect(problem);
    for (const labelPair& c : collisions_)
    {
        const vector offset(x[c.first()] - x[c.second()]);
        repel(c.first(), areas[c.first()], offset);
        repel(c.second(), areas[c.second()], -offset);
    }
    for (const contactPair& pair : problem.found.pairs)
    {
        if (pair.face < 0 && pair.gap < problem.range)
        {
            repel(pair.node, areas[pair.node], 2*pair.gap*pair.normal);
        }
    }
}


void Foam::fsi::thesisContact::warn(const contactProblem& problem)
{
    if (warned_ || problem.found.pairs.empty())
    {
        return;
    }
    const scalar kinetic = 0.5*sum
    (
        problem.bodies.masses()*magSqr(problem.velocities)
    );
    const scalar springs = potentialEnergy(problem);
    if (springs > 10*kinetic)
    {
        warned_ = true;
        WarningInFunction
            << "The springs of contact law 'thesis' hold " << springs
            << " J where all boundary nodes move with " << kinetic << " J."
            << nl
            << "    Its force does not vanish at the distance at which contact"
            << " is noticed, so that it gives such energy to the bodies;" << nl
            << "    runs may end with a velocity or Courant number without"
            << " bounds. Lower the entry 'stiffness' (now " << stiffness_
            << " Pa)," << nl
            << "    or use the law 'elastic', which adds no energy" << nl
            << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::thesisContact::potentialEnergy
(
    const contactProblem& problem
)
{
    const pointField& x = problem.surfaces.points();
    const scalarField& areas = problem.bodies.areas();
    repelAll(problem);

    scalar sum = 0;
    for (const labelPair& c : collisions_)
    {
        const scalar d = mag(x[c.first()] - x[c.second()]);
        for (const label nodei : {c.first(), c.second()})
        {
            sum += energy(areas[nodei], d)/count_[nodei];
        }
    }
    return sum;
}


void Foam::fsi::thesisContact::addForces
(
    const contactProblem& problem,
    vectorField& force,
    contactStatistics&
)
{
    warn(problem);
    repelAll(problem);
    forAll(count_, nodei)
    {
        if (count_[nodei] == 0)
        {
            continue;
        }
        force[nodei] += repulsion_[nodei]/count_[nodei];
        if (cancel_)
        {
            force[nodei] -=
                problem.bodies.internalForces()[nodei]
              + problem.bodies.masses()[nodei]/problem.step.tau
               *problem.velocities[nodei];
        }
    }
}


// ************************************************************************* //
