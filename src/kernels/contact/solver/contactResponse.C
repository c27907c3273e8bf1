// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactResponse.H"
#include "SubField.H"

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
    const label nOther = (*bodies_)[faceOwner(pair)].nModes;
    for (label k = 0; k < nOther; ++k)
    {
        scalar share = 0;
        for (label i = 0; i < surfaces_->nNodes(); ++i)
        {
            share -=
                pair.couple
              ? bodies_->mode(f[i], k) & pair.share(i)
              : pair.weights[i]*(bodies_->mode(f[i], k) & n);
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


void Foam::fsi::contactResponse::setRows(const UList<contactPair>& pairs)
{
    taken_.setSize(surfaces_->points().size());
    taken_ = false;
    for (const contactPair& pair : pairs)
    {
        taken_[pair.node] = true;
        for (label i = 0; pair.face >= 0 && i < surfaces_->nNodes(); ++i)
        {
            taken_[surfaces_->faces()[pair.face][i]] = true;
        }
    }
    rows_.clear();
    rowStart_.setSize(surfaces_->size() + 1);
    for (label objecti = 0; objecti < surfaces_->size(); ++objecti)
    {
        rowStart_[objecti] = rows_.size();
        const label start = surfaces_->pointStart()[objecti];
        const label end = surfaces_->pointStart()[objecti + 1];
        for (label nodei = start; nodei < end; ++nodei)
        {
            if (taken_[nodei])
            {
                rows_.append(nodei - start);
            }
        }
    }
    rowStart_.last() = rows_.size();
}


void Foam::fsi::contactResponse::addImpulse
(
    const label objecti,
    const label nNodes,
    const label* nodes,
    const scalar* weights,
    const vector& impulse
)
{
    const Eigen::MatrixXd* B = (*bodies_)[objecti].inverse;
    if (!B)
    {
        return;
    }
    const label start = surfaces_->pointStart()[objecti];
    vector* v = &velocities_[start];
    const label* rows = rows_.cdata() + rowStart_[objecti];
    const label nRows = rowStart_[objecti + 1] - rowStart_[objecti];
    if (sum_.size() < nRows)
    {
        sum_.setSize(nRows);
    }
    for (label i = 0; i < nNodes; ++i)
    {
        const double* column = B->col(nodes[i] - start).data();
        for (label row = 0; row < nRows; ++row)
        {
            sum_[row] =
                (i > 0 ? sum_[row] : 0) + weights[i]*column[rows[row]];
        }
    }
    for (label row = 0; row < nRows; ++row)
    {
        v[rows[row]] += sum_[row]*impulse;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactResponse::reset
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const UList<contactPair>& pairs
)
{
    surfaces_ = &surfaces;
    bodies_ = &bodies;
    pairs_ = pairs.cdata();
    velocities_ = velocities;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (bodies.pushedElsewhere(objecti))
        {
            const label start = surfaces.pointStart()[objecti];
            const label n = surfaces.pointStart()[objecti + 1] - start;
            SubField<vector>(velocities_, n, start) = vector(Zero);
        }
    }
    amplitudes_.setSize(surfaces.size());
    amplitudes_ = modeValues(0.0);
    if (nodeShares_.size() < pairs.size())
    {
        nodeShares_.setSize(2*pairs.size());
        otherShares_.setSize(2*pairs.size());
    }
    setRows(pairs);
    forAll(pairs, pairi)
    {
        setShares(pairi);
    }
}


Foam::scalar Foam::fsi::contactResponse::compliance(const label pairi) const
{
    const contactPair& pair = pairs_[pairi];
    const vector& n = pair.normal;
    const label object = own(pair);
    const contactBodies::body& b = (*bodies_)[object];
    const bool self = pair.face >= 0 && faceOwner(pair) == object;
    if (pair.component >= 0)
    {
        return frictionCompliance(pair);
    }

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
            sum += wi*pair.weights[j]*inverse(faceOwner(pair), f[i], f[j]);
        }
        sum -= self ? 2*wi*inverse(object, pair.node, f[i]) : 0;
    }
    const contactBodies::body& other = (*bodies_)[faceOwner(pair)];
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

    const scalar whole = 1;
    addImpulse(own(pair), 1, &pair.node, &whole, j);
    addModes(own(pair), nodeShares_[pairi], impulse);
    if (pair.face >= 0)
    {
        const surfaceFace& f = surfaces_->faces()[pair.face];
        addImpulse
        (
            faceOwner(pair),
            surfaces_->nNodes(),
            f.cdata(),
            pair.weights.cdata(),
            -j
        );
        for (label i = 0; pair.couple && i < surfaces_->nNodes(); ++i)
        {
            const vector& c = (*pair.couple)[i];
            addImpulse(faceOwner(pair), 1, &f[i], &whole, -impulse*c);
        }
        addModes(faceOwner(pair), otherShares_[pairi], impulse);
    }
}


// ************************************************************************* //
