// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactResponse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactResponse::compliance
(
    const label objecti,
    const label i,
    const vector& n,
    const label j,
    const vector& m
) const
{
    const contactBodies::body& b = (*bodies_)[objecti];
    const label start = surfaces_->pointStart()[objecti];

    scalar sum = 0;
    if (b.inverse && !b.coupled)
    {
        sum = (*b.inverse)(i - start, j - start)*(n & m);
    }
    else if (b.inverse)
    {
        const Eigen::MatrixXd& B = *b.inverse;
        const label nNodes = B.rows()/2;
        for (label c = 0; c < 4; ++c)
        {
            const label row = i - start + (c/2)*nNodes;
            const label column = j - start + (c % 2)*nNodes;
            sum += B(row, column)*n[c/2]*m[c % 2];
        }
    }
    for (label k = 0; k < b.nModes; ++k)
    {
        sum +=
            b.coefficients[k]
           *(bodies_->mode(i, k) & n)
           *(bodies_->mode(j, k) & m);
    }
    return sum;
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
    const contactBodies::body& b = (*bodies_)[objecti];
    const label start = surfaces_->pointStart()[objecti];

    for (label n = 0; n < nNodes; ++n)
    {
        const vector share(weights[n]*impulse);
        for (label k = 0; k < b.nModes; ++k)
        {
            amplitudes_[objecti][k] +=
                b.coefficients[k]*(bodies_->mode(nodes[n], k) & share);
        }
        if (b.inverse && b.coupled && weights[n] != 0)
        {
            const Eigen::MatrixXd& B = *b.inverse;
            const label nNodes = B.rows()/2;
            vector* v = &velocities_[start];
            for (label column = 0; column < 2; ++column)
            {
                const double* response =
                    B.col(nodes[n] - start + column*nNodes).data();
                for (label i = 0; i < nNodes; ++i)
                {
                    v[i].x() += response[i]*share[column];
                    v[i].y() += response[nNodes + i]*share[column];
                }
            }
        }
        else if (b.inverse && weights[n] != 0)
        {
            const double* column = b.inverse->col(nodes[n] - start).data();
            vector* v = &velocities_[start];
            for (label i = 0; i < b.inverse->rows(); ++i)
            {
                v[i] += column[i]*share;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactResponse::reset
(
    const surfaceSet& surfaces,
    const contactBodies& bodies
)
{
    surfaces_ = &surfaces;
    bodies_ = &bodies;
    velocities_ = surfaces.velocities();
    amplitudes_.setSize(surfaces.size());
    amplitudes_ = FixedList<scalar, contactBodies::maxModes>(0.0);
}


Foam::scalar Foam::fsi::contactResponse::compliance
(
    const contactPair& pair
) const
{
    const vector& n = pair.normal;
    const label own = surfaces_->pointObject()[pair.node];
    scalar sum = compliance(own, pair.node, n, pair.node, n);
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
            sum += wi*pair.weights[j]*compliance(pair.other, f[i], n, f[j], n);
        }
        if (pair.other == own)
        {
            sum -= 2*wi*compliance(own, pair.node, n, f[i], n);
        }
    }
    return sum;
}


void Foam::fsi::contactResponse::addImpulse
(
    const contactPair& pair,
    const scalar impulse
)
{
    const vector j(impulse*pair.normal);
    const scalar one = 1;
    addImpulse
    (
        surfaces_->pointObject()[pair.node], 1, &pair.node, &one, j
    );
    if (pair.face >= 0)
    {
        addImpulse
        (
            pair.other,
            surfaces_->nNodes(),
            surfaces_->faces()[pair.face].cdata(),
            pair.weights.cdata(),
            -j
        );
    }
}


// ************************************************************************* //
