// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactCarry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contactCarry::add
(
    const scalar sign,
    const groupNodal& change,
    groupNodal& v
)
{
    forAll(change, groupi)
    {
        if (change[groupi].size())
        {
            v[groupi] += sign*change[groupi];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactCarry::clear()
{
    carried_.clear();
    before_.clear();
    pushed_.clear();
}


void Foam::fsi::contactCarry::begin(population& bodies, groupNodal& v)
{
    carried_.setSize(v.size());
    forAll(v, groupi)
    {
        bodyGroup& group = bodies.groups()[groupi];
        const Eigen::MatrixXd& given = group.contactForce();
        carried_[groupi].resize(0, 0);
        if (given.size() && !given.isZero(0))
        {
            Eigen::MatrixXd force
            (
                Eigen::MatrixXd::Zero(v[groupi].rows(), v[groupi].cols())
            );
            force.topRows(given.rows()) = given;
            group.response().respond(force, carried_[groupi]);
        }
    }
    before_ = carried_;
    add(1, carried_, v);
}


void Foam::fsi::contactCarry::next(const bool refused, groupNodal& v)
{
    if (pushed_.empty())
    {
        return;
    }
    const groupNodal last(carried_);
    add(-1, carried_, v);
    carried_ = refused ? before_ : pushed_;
    before_ = last;
    add(1, carried_, v);
}


void Foam::fsi::contactCarry::putIn
(
    const population& bodies,
    const vectorField& force,
    groupNodal& v
)
{
    groupNodal all;
    bodies.layout().toGroups(force, all);
    pushed_.setSize(v.size());
    forAll(pushed_, groupi)
    {
        const bodyGroup& group = bodies.groups()[groupi];
        group.response().respond(all[groupi], pushed_[groupi]);
    }
    add(1, pushed_, v);
}


void Foam::fsi::contactCarry::keep
(
    const vectorField& force,
    const groupNodal& v,
    population& bodies
) const
{
    if (carried_.empty() || pushed_.empty())
    {
        return;
    }
    groupNodal boundary;
    bodies.layout().toBoundary(force, boundary);
    forAll(v, groupi)
    {
        bodyGroup& group = bodies.groups()[groupi];
        group.contactForce() = boundary[groupi];
        const label nDims = group.shape().nDims();
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            const auto w = pushed_[groupi].middleCols(nDims*copyi, nDims);
            const auto end = v[groupi].middleCols(nDims*copyi, nDims);
            const auto start = group.velocities().middleCols
            (
                nDims*copyi, nDims
            );
            const scalar size = w.squaredNorm();
            const scalar changed = w.cwiseProduct(end - start).sum();
            group.contactForce().middleCols(nDims*copyi, nDims) *=
                size > 0 ? min(max(1 - changed/size, 0.0), 1.0) : 0.0;
        }
    }
}


// ************************************************************************* //
