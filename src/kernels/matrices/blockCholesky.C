// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockCholesky.H"
#include "laneReference.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A column of a block, or the two components of a node, in one register
typedef Eigen::Array2d pair;

static inline Eigen::Map<pair> at(scalar* place)
{
    return Eigen::Map<pair>(place);
}

static inline Eigen::Map<const pair> at(const scalar* place)
{
    return Eigen::Map<const pair>(place);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::blockCholesky::finishColumn(const label column)
{
    scalar* d = values_.data() + 4*column;
    const scalar a = d[0], b = d[1], c = d[3];
    const scalar rest = c - sqr(b)/a;
    if (!(a > 0) || !(rest > 0))
    {
        return false;
    }
    d[0] = 1/std::sqrt(a);
    d[3] = 1/std::sqrt(rest);
    d[1] = -b/a*d[3];
    d[2] = 0;

    // L_ik = A_ik L_kk^-T
    const label start = pattern_->start(column);
    const label n = pattern_->start(column + 1) - start;
    scalar* blocks = values_.data() + 4*(pattern_->size() + start);
    for (scalar* block = blocks; block < blocks + 4*n; block += 4)
    {
        const pair first = at(block);
        at(block) = first*d[0];
        at(block + 2) = first*d[1] + at(block + 2)*d[3];
    }

    const label* target = pattern_->updates(column);
    for (label i = 0; i < n; ++i)
    {
        const pair p0 = at(blocks + 4*i), p1 = at(blocks + 4*i + 2);
        for (label j = 0; j <= i; ++j, ++target)
        {
            const scalar* q = blocks + 4*j;
            scalar* result = values_.data() + 4*(*target);
            at(result) -= p0*q[0] + p1*q[2];
            at(result + 2) -= p0*q[1] + p1*q[3];
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::blockCholesky::factor
(
    const blockPattern& pattern,
    const scalarField& values
)
{
    pattern_ = &pattern;
    values_ = values;
    rows_.resize(2*pattern.size());
    for (label k = 0; k < pattern.size(); ++k)
    {
        if (!finishColumn(k))
        {
            return false;
        }
    }
    return true;
}


void Foam::fsi::blockCholesky::solve(double* x) const
{
    const label n = pattern_->size();
    const scalar* lower = values_.cdata() + 4*n;
    const auto row = [&](const label place) { return at(&rows_[2*place]); };

    pattern_->toRows(x, rows_.data());
    for (label k = 0; k < n; ++k)
    {
        const scalar* d = values_.cdata() + 4*k;
        const pair y = at(d)*row(k)[0] + at(d + 2)*row(k)[1];
        row(k) = y;
        for (label e = pattern_->start(k); e < pattern_->start(k + 1); ++e)
        {
            const scalar* l = lower + 4*e;
            row(pattern_->rows()[e]) -= at(l)*y[0] + at(l + 2)*y[1];
        }
    }
    for (label k = n - 1; k >= 0; --k)
    {
        pair first = pair::Zero(), second = pair::Zero();
        for (label e = pattern_->start(k); e < pattern_->start(k + 1); ++e)
        {
            const scalar* l = lower + 4*e;
            const pair below = row(pattern_->rows()[e]);
            first += at(l)*below;
            second += at(l + 2)*below;
        }
        const scalar* d = values_.cdata() + 4*k;
        const scalar a = row(k)[0] - first.sum();
        const scalar b = row(k)[1] - second.sum();
        row(k) << d[0]*a + d[1]*b, d[3]*b;
    }
    pattern_->fromRows(rows_.cdata(), x);
}


void Foam::fsi::blockCholesky::solveLanes
(
    scalarField& rows,
    const label first
) const
{
    typedef laneArray<lanes> array;
    const label n = pattern_->size();
    const scalar* lower = values_.cdata() + 4*n;
    const auto row = [&](const label i) { return at<lanes>(rows, i); };
    const auto set = [&](const label i) { return to<lanes>(rows, i); };

    for (label k = first; k < n; ++k)
    {
        const scalar* d = values_.cdata() + 4*k;
        const array a = d[0]*row(2*k);
        const array b = d[1]*row(2*k) + d[3]*row(2*k + 1);
        set(2*k) = a;
        set(2*k + 1) = b;
        for (label e = pattern_->start(k); e < pattern_->start(k + 1); ++e)
        {
            const scalar* l = lower + 4*e;
            const label i = 2*pattern_->rows()[e];
            set(i) -= l[0]*a + l[2]*b;
            set(i + 1) -= l[1]*a + l[3]*b;
        }
    }
    for (label k = n - 1; k >= 0; --k)
    {
        array a = row(2*k), b = row(2*k + 1);
        for (label e = pattern_->start(k); e < pattern_->start(k + 1); ++e)
        {
            const scalar* l = lower + 4*e;
            const label i = 2*pattern_->rows()[e];
            a -= l[0]*row(i) + l[1]*row(i + 1);
            b -= l[2]*row(i) + l[3]*row(i + 1);
        }
        const scalar* d = values_.cdata() + 4*k;
        set(2*k) = d[0]*a + d[1]*b;
        set(2*k + 1) = d[3]*b;
    }
}


Eigen::MatrixXd Foam::fsi::blockCholesky::inverse(const label nB) const
{
    const label n = pattern_->size();
    Eigen::MatrixXd result(2*nB, 2*nB);
    scalarField rows(2*n*lanes);

    // Unknowns in the pattern's order, so that many rows stay zero
    labelList nodeAt(n);
    for (label i = 0; i < n; ++i)
    {
        nodeAt[pattern_->place(i)] = i;
    }
    std::vector<label> unknowns;
    for (const label node : nodeAt)
    {
        if (node < nB)
        {
            unknowns.push_back(node);
            unknowns.push_back(node + nB);
        }
    }

    for (label begin = 0; begin < 2*nB; begin += lanes)
    {
        const label end = min(begin + lanes, 2*nB);
        rows = 0;
        for (label i = begin; i < end; ++i)
        {
            const label place = pattern_->place(unknowns[i] % nB);
            rows[lanes*(2*place + unknowns[i]/nB) + i - begin] = 1;
        }
        solveLanes(rows, pattern_->place(unknowns[begin] % nB));
        for (label i = begin; i < end; ++i)
        {
            for (label j = 0; j < 2*nB; ++j)
            {
                const label place = pattern_->place(j % nB);
                result(j, unknowns[i]) =
                    rows[lanes*(2*place + j/nB) + i - begin];
            }
        }
    }
    return 0.5*(result + result.transpose());
}


// ************************************************************************* //
