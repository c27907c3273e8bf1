// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactResponse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contactResponse::setShares(const label pairi)
{
    const contactPair& pair = pairs_[pairi];
    const vector& n = pair.normal;
    const label nModes = (*bodies_)[own(pair)].nModes;
    for (label k = 0; k < nModes; ++k)
    {
        nodeShares_[pairi][k] = bodies_->mode(pair.node, k) & n;
    }
    if (pair.face < 0)
    {
        return;
    }

    const surfaceFace& f = surfaces_->faces()[pair.face];
    const label nOther = (*bodies_)[pair.other].nModes;
    for (label k = 0; k < nOther; ++k)
    {
        scalar share = 0;
        for (label i = 0; i < surfaces_->nNodes(); ++i)
        {
            share -= pair.weights[i]*(bodies_->mode(f[i], k) & n);
        }
        otherShares_[pairi][k] = share;
    }
}


Foam::scalar Foam::fsi::contactResponse::inverse
(
    const label objecti,
    const label i,
    const label j
) const
{
    const Eigen::MatrixXd* B = (*bodies_)[objecti].inverse;
    const label start = surfaces_->pointStart()[objecti];
    return B ? (*B)(i - start, j - start) : 0;
}


void Foam::fsi::contactResponse::addImpulse
(
    const label objecti,
    const label nodei,
    const vector& impulse
)
{
    const Eigen::MatrixXd* B = (*bodies_)[objecti].inverse;
    if (!B)
    {
        return;
    }
    const label start = surfaces_->pointStart()[objecti];
    const double* column = B->col(nodei - start).data();
    vector* v = &velocities_[start];
    for (label i = 0; i < B->rows(); ++i)
    {
        v[i] += column[i]*impulse;
    }
}


void Foam::fsi::contactResponse::addModes
(
    const label objecti,
    const modeValues& shares,
    const scalar impulse
)
{
    const contactBodies::body& b = (*bodies_)[objecti];
    for (label k = 0; k < b.nModes; ++k)
    {
        amplitudes_[objecti][k] += b.coefficients[k]*shares[k]*impulse;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactResponse::reset
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactPair>& pairs
)
{
    surfaces_ = &surfaces;
    bodies_ = &bodies;
    pairs_ = pairs.cdata();
    velocities_ = surfaces.velocities();
    amplitudes_.setSize(surfaces.size());
    amplitudes_ = modeValues(0.0);

    if (nodeShares_.size() < pairs.size())
    {
        nodeShares_.setSize(2*pairs.size());
        otherShares_.setSize(2*pairs.size());
    }
    forAll(pairs, pairi)
    {
        setShares(pairi);
    }
}


Foam::scalar Foam::fsi::contactResponse::compliance(const label pairi) const
{
    const contactPair& pair = pairs_[pairi];
    const label object = own(pair);
    const contactBodies::body& b = (*bodies_)[object];
    const bool self = pair.face >= 0 && pair.other == object;

    scalar sum = inverse(object, pair.node, pair.node);
    for (label k = 0; k < b.nModes; ++k)
    {
        const scalar share =
            nodeShares_[pairi][k] + (self ? otherShares_[pairi][k] : 0);
        sum += b.coefficients[k]*sqr(share);
    }
    if (pair.face < 0)
    {
        return sum;
    }

    const surfaceFace& f = surfaces_->faces()[pair.face];
    for (label i = 0; i < surfaces_->nNodes(); ++i)
    {
        const scalar wi = pair.weights[i];
        for (label j = 0; j < surfaces_->nNodes(); ++j)
        {
            sum += wi*pair.weights[j]*inverse(pair.other, f[i], f[j]);
        }
        sum -= self ? 2*wi*inverse(object, pair.node, f[i]) : 0;
    }
    const contactBodies::body& other = (*bodies_)[pair.other];
    for (label k = 0; k < other.nModes && !self; ++k)
    {
        sum += other.coefficients[k]*sqr(otherShares_[pairi][k]);
    }
    return sum;
}


void Foam::fsi::contactResponse::addImpulse
(
    const label pairi,
    const scalar impulse
)
{
    const contactPair& pair = pairs_[pairi];
    const vector j(impulse*pair.normal);

    addImpulse(own(pair), pair.node, j);
    addModes(own(pair), nodeShares_[pairi], impulse);
    if (pair.face >= 0)
    {
        const surfaceFace& f = surfaces_->faces()[pair.face];
        for (label i = 0; i < surfaces_->nNodes(); ++i)
        {
            if (pair.weights[i] != 0)
            {
                addImpulse(pair.other, f[i], -pair.weights[i]*j);
            }
        }
        addModes(pair.other, otherShares_[pairi], impulse);
    }
}


// ************************************************************************* //
