// SPDX-License-Identifier: GPL-3.0-or-later

#include "potentialContact.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- 1/e^2 of the entry `restitution`
static scalar readApproachFactor(const dictionary& dict)
{
    const scalar e = readPositive(dict, "restitution", 1);
    if (e > 1 || e < 0.01)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'restitution' in dictionary " << dict.name()
            << " is " << e << " but must lie between 0.01 and 1"
            << exit(FatalIOError);
    }
    return 1/sqr(e);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::potentialContact::potentialContact
(
    const dictionary& dict,
    const contactScales& scales
)
:
    approachFactor_(readApproachFactor(dict)),
    range_(scales.range),
    solver_(dict)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::potentialContact::meanRepulsion
(
    const scalar g0,
    const scalar g1,
    scalar& slope
) const
{
    const scalar change = g1 - g0;
    if (mag(change) < 1e-5*range_)
    {
        const scalar middle = 0.5*(g0 + g1);
        slope = middle < range_ ? 0.5*repulsionSlope(middle) : 0;
        return middle < range_ ? repulsion(middle) : 0;
    }

    const scalar r0 = g0 < range_ ? repulsionEnergy(g0) : 0;
    const scalar r1 = g1 < range_ ? repulsionEnergy(g1) : 0;
    const scalar mean = (r0 - r1)/change;
    slope = ((g1 < range_ ? repulsion(g1) : 0) - mean)/change;
    return mean;
}


Foam::scalar Foam::fsi::potentialContact::endGap
(
    const contactState& pair,
    const scalar coast,
    const scalar factor
) const
{
    const scalar g0 = pair.gap;

    // The residual g - coast - factor*mean is concave and increasing: Newton
    // steps reach its root from below, after at most one step across it
    scalar g = max
    (
        coast,
        pair.guess < range_ ? pair.guess : 0.25*min(g0, range_)
    );
    for (label i = 0; i < 100; ++i)
    {
        scalar slope;
        const scalar mean = meanRepulsion(g0, g, slope);
        const scalar step = (g - coast - factor*mean)/(1 - factor*slope);
        const scalar old = g;
        g = max(g - step, coast);
        // Quadratic: the error is far smaller than the last step
        if (mag(g - old) < 1e-9*range_)
        {
            break;
        }
    }
    return g;
}


Foam::scalar
Foam::fsi::potentialContact::impulse(const contactState& pair) const
{
    const scalar gap = pair.gap;
    const scalar perPressure = pair.dt*pair.compliance*pair.area;
    const scalar factor = pair.dt*perPressure;
    const scalar pull = gap < range_ ? attraction(gap) : 0;
    const scalar straight = gap + pair.dt*pair.velocity;
    const scalar coast = straight - factor*pull;
    if (min(gap, coast) >= range_)
    {
        return 0;
    }

    scalar push = 1;
    scalar end = endGap(pair, coast, factor);
    if (end < gap && approachFactor_ > 1)
    {
        push = approachFactor_;
        end = min(endGap(pair, coast, push*factor), gap);
    }

    // From the law where it is soft, else from the gap it leads to: each is
    // the one that is less sensitive to an error of the gap
    scalar slope;
    const scalar mean = push*meanRepulsion(gap, end, slope);
    if (-push*factor*slope < 1 && end != gap)
    {
        return pair.area*pair.dt*(mean - pull);
    }
    return (end - straight)/(pair.dt*pair.compliance);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::fsi::potentialContact::keys(const wordList& own)
{
    wordList all
    (
        {
            "type", "restitution", "tolerance", "maxSweeps",
            "frictionCoefficient"
        }
    );
    all.append(own);
    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::potentialContact::attraction(const scalar) const
{
    return 0;
}


Foam::scalar Foam::fsi::potentialContact::attractionEnergy(const scalar) const
{
    return 0;
}


Foam::scalar Foam::fsi::potentialContact::energy(const scalar gap) const
{
    return gap < range_ ? repulsionEnergy(gap) + attractionEnergy(gap) : 0;
}


Foam::scalar Foam::fsi::potentialContact::pressure(const scalar gap) const
{
    return gap < range_ ? repulsion(gap) - attraction(gap) : 0;
}


Foam::scalar Foam::fsi::potentialContact::potentialEnergy
(
    const contactProblem& problem
)
{
    scalar sum = 0;
    for (const contactPair& pair : problem.found.pairs)
    {
        if (!problem.feelsLaw(pair))
        {
            continue;
        }
        const scalar gap = pair.stretch*problem.startGap(pair);
        sum += problem.area(pair)/pair.stretch*energy(gap);
    }
    return sum;
}


void Foam::fsi::potentialContact::addForces
(
    const contactProblem& problem,
    vectorField& force,
    contactStatistics& statistics
)
{
    statistics.sweeps = solver_.solve(problem, *this);
    solver_.addForces(problem, force);
}


// ************************************************************************* //
