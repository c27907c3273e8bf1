// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactFriction.H"
#include "readBetween.H"
#include "symmTensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Does the face of a component belong to a body that keeps its shape?
static bool hasCouple(const contactProblem& problem, const contactPair& pair)
{
    return pair.wall < 0 && problem.bodies[pair.other].keepsShape;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contactFriction::contactFriction(const dictionary& dict)
:
    coefficient_(readScalarBetween(dict, "frictionCoefficient", 0, 0, 10))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contactFriction::setCouple
(
    const surfaceSet& surfaces,
    const contactPair& component,
    const vector& normal,
    FixedList<vector, 3>& couple
) const
{
    const surfaceFace& f = surfaces.faces()[component.face];
    point middle(Zero);
    for (label i = 0; i < nDims_; ++i)
    {
        middle += surfaces.points()[f[i]]/nDims_;
    }
    symmTensor inertia(Zero);
    for (label i = 0; i < nDims_; ++i)
    {
        const vector r(surfaces.points()[f[i]] - middle);
        inertia += magSqr(r)*symmTensor::I - sqr(r);
    }
    const vector moment(component.gap*(normal ^ component.normal));
    const vector turn
    (
        nDims_ == 2 ? moment/inertia.zz() : inv(inertia) & moment
    );
    for (label i = 0; i < nDims_; ++i)
    {
        couple[i] = turn ^ (surfaces.points()[f[i]] - middle);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactFriction::set(const contactProblem& problem)
{
    nDims_ = problem.surfaces.nDims();
    nPairs_ = problem.found.pairs.size();
    loads_.setSize(nPairs_);
    loads_ = 0;
    couples_.setSize(nDims_*nPairs_);
    pairs_.pairs = problem.found.pairs;
    for (label pairi = 0; pairi < nPairs_; ++pairi)
    {
        const vector n(pairs_.pairs[pairi].normal);
        for (label d = 0; d < nDims_; ++d)
        {
            contactPair component(pairs_.pairs[pairi]);
            component.component = d;
            component.normal = -n[d]*n;
            component.normal[d] += 1;
            if (hasCouple(problem, component))
            {
                FixedList<vector, 3>& couple = couples_[nDims_*pairi + d];
                setCouple(problem.surfaces, component, n, couple);
                component.couple = &couple;
            }
            pairs_.pairs.append(component);
        }
    }
}


Foam::fsi::contactProblem Foam::fsi::contactFriction::with
(
    const contactProblem& problem
) const
{
    return
    {
        problem.surfaces, problem.velocities, problem.bodies, pairs_,
        problem.range, problem.step, problem.exchange, problem.touching,
        problem.patchDepth, problem.lawOnRigid, problem.walls
    };
}


void Foam::fsi::contactFriction::setLoad
(
    const contactProblem& problem,
    const label pairi,
    const scalar impulse
)
{
    const contactPair& pair = problem.found.pairs[pairi];
    const bool smooth = pair.wall >= 0 && (*problem.walls)[pair.wall].smooth();
    loads_[pairi] = smooth ? 0 : max(impulse, 0.0);
}


Foam::vector Foam::fsi::contactFriction::wallVelocity
(
    const contactProblem& problem,
    const contactPair& pair
)
{
    return
        pair.wall >= 0
      ? (*problem.walls)[pair.wall].velocity()
      : vector(Zero);
}


Foam::vector Foam::fsi::contactFriction::limited
(
    const label pairi,
    const vector& sticking
) const
{
    const vector& n = pairs_.pairs[pairi].normal;
    const vector along(sticking - (sticking & n)*n);
    const scalar most = coefficient_*loads_[pairi];
    const scalar size = mag(along);
    return size > most ? vector(most/size*along) : along;
}


// ************************************************************************* //
