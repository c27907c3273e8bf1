// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockMatrix.H"
#include "error.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::blockMatrix::setPattern
(
    const label n,
    const blockPattern::entries& entries
)
{
    pattern_ = blockPattern(n, entries);
    valueOf_.resize(entries.size());
    forAll(valueOf_, i)
    {
        valueOf_[i] = pattern_.valueOf(entries[i].row(), entries[i].col());
    }
}


void Foam::fsi::blockMatrix::set(const blockPattern::entries& entries)
{
    if (label(entries.size()) != valueOf_.size())
    {
        FatalErrorInFunction
            << entries.size() << " entries for a pattern of "
            << valueOf_.size() << exit(FatalError);
    }
    values_.resize(4*pattern_.nBlocks());
    values_ = 0;
    forAll(valueOf_, i)
    {
        if (valueOf_[i] >= 0)
        {
            values_[valueOf_[i]] += entries[i].value();
        }
    }
}


void Foam::fsi::blockMatrix::multiply(const double* x, double* y) const
{
    const label n = pattern_.size();
    std::vector<scalar> from(2*n), to(2*n, 0);
    pattern_.toRows(x, from.data());
    for (label k = 0; k < n; ++k)
    {
        const scalar* p = from.data() + 2*k;
        scalar* q = to.data() + 2*k;
        const scalar* d = values_.cdata() + 4*k;
        q[0] += d[0]*p[0] + d[2]*p[1];
        q[1] += d[1]*p[0] + d[3]*p[1];
        for (label e = pattern_.start(k); e < pattern_.start(k + 1); ++e)
        {
            const scalar* a = values_.cdata() + 4*(n + e);
            const scalar* r = from.data() + 2*pattern_.rows()[e];
            scalar* s = to.data() + 2*pattern_.rows()[e];
            s[0] += a[0]*p[0] + a[2]*p[1];
            s[1] += a[1]*p[0] + a[3]*p[1];
            q[0] += a[0]*r[0] + a[1]*r[1];
            q[1] += a[2]*r[0] + a[3]*r[1];
        }
    }
    pattern_.fromRows(to.data(), y);
}


// ************************************************************************* //
