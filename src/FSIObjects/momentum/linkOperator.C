// SPDX-License-Identifier: GPL-3.0-or-later

#include "linkOperator.H"
#include "fetchAhead.H"

#include <type_traits>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::linkOperator::linkOperator
(
    redBlackMatrix& matrix,
    const direction nDims
)
:
    matrix_(matrix),
    nDims_(nDims)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Action>
void Foam::fsi::linkOperator::forDims(const Action& action) const
{
    if (nDims_ == 2)
    {
        action(std::integral_constant<int, 2>());
    }
    else
    {
        action(std::integral_constant<int, 3>());
    }
}


void Foam::fsi::linkOperator::chain
(
    const UList<wallLink>& links,
    const scalar viscosity
)
{
    last_.setSize(matrix_.nRows(), -1);
    unsorted_.clear();
    unsortedRows_.clear();
    previous_.clear();
    for (const wallLink& link : links)
    {
        const label row = matrix_.row(link.cell);
        label& last = last_[row];
        if (last < 0)
        {
            unsortedRows_.append(row);
        }
        const scalar g = viscosity*link.conductance;
        matrix_.addToDiagonal(link.cell, g);
        link.place.forPairs
        (
            [&](const label a, const scalar u, const label b, const scalar v)
            {
                previous_.append(last);
                last = unsorted_.size();
                unsorted_.append({a, b, g*u, g*v});
            }
        );
    }
}


void Foam::fsi::linkOperator::sortRows()
{
    const auto node = [&](const label row)
    {
        return unsorted_[last_[row]].nodeA;
    };
    label nNodes = 0;
    for (const label row : unsortedRows_)
    {
        nNodes = max(nNodes, node(row) + 1);
    }
    place_.setSize(nNodes + 1);
    place_ = 0;
    for (const label row : unsortedRows_)
    {
        ++place_[node(row) + 1];
    }
    for (label nodei = 0; nodei < nNodes; ++nodei)
    {
        place_[nodei + 1] += place_[nodei];
    }
    rows_.setSize(unsortedRows_.size());
    for (const label row : unsortedRows_)
    {
        rows_[place_[node(row)]++] = row;
    }
}


void Foam::fsi::linkOperator::keepValues()
{
    values_.clear();
    for (const label row : rows_)
    {
        for (label d = 0; d < nDims_; ++d)
        {
            values_.append(matrix_.value(row)[d]);
        }
    }
}


template<int nDims>
inline Foam::FixedList<Foam::scalar, nDims> Foam::fsi::linkOperator::ofWalls
(
    const label rowi,
    const vectorField& v,
    const scalar scale
) const
{
    FixedList<scalar, nDims> sum(Zero);
    for (label j = start_[rowi]; j < start_[rowi + 1]; ++j)
    {
        const entry& link = entries_[j];
        const vector& a = v[link.nodeA];
        const vector& b = v[link.nodeB];
        for (int d = 0; d < nDims; ++d)
        {
            sum[d] += scale*(link.partA*a[d] + link.partB*b[d]);
        }
    }
    return sum;
}


template<int nDims>
void Foam::fsi::linkOperator::doSetSources(const vectorField& v)
{
    forAll(rows_, i)
    {
        const FixedList<scalar, nDims> part(ofWalls<nDims>(i, v, 1));
        scalar* source = matrix_.source(rows_[i]);
        for (int d = 0; d < nDims; ++d)
        {
            source[d] = sources_[nDims*i + d] + part[d];
        }
    }
}


template<int nDims>
void Foam::fsi::linkOperator::doStartCorrection(const vectorField& v)
{
    const scalar scale = matrix_.correctionScale();
    residuals_.setSize(sources_.size());
    forAll(rows_, i)
    {
        const FixedList<scalar, nDims> part(ofWalls<nDims>(i, v, scale));
        const floatScalar* residual = matrix_.residual(rows_[i]);
        for (int d = 0; d < nDims; ++d)
        {
            residuals_[nDims*i + d] = residual[d] - part[d];
        }
    }
}


template<int nDims>
void Foam::fsi::linkOperator::doSetResiduals(const vectorField& v)
{
    const scalar scale = matrix_.correctionScale();
    forAll(rows_, i)
    {
        fetchAhead(*matrix_.residual(fetchedAhead(rows_, i)));

        const FixedList<scalar, nDims> part(ofWalls<nDims>(i, v, scale));
        floatScalar* residual = matrix_.residual(rows_[i]);
        for (int d = 0; d < nDims; ++d)
        {
            residual[d] = floatScalar(residuals_[nDims*i + d] + part[d]);
        }
    }
}


template<int nDims>
void Foam::fsi::linkOperator::doAddForce
(
    const scalar density,
    vectorField& force
) const
{
    const scalar scale = 1/matrix_.correctionScale();
    forAll(rows_, i)
    {
        fetchAhead(*matrix_.correction(fetchedAhead(rows_, i)));

        const floatScalar* correction = matrix_.correction(rows_[i]);
        FixedList<scalar, nDims> momentum;
        for (int d = 0; d < nDims; ++d)
        {
            momentum[d] = density*(values_[nDims*i + d] + scale*correction[d]);
        }
        for (label j = start_[i]; j < start_[i + 1]; ++j)
        {
            const entry& link = entries_[j];
            for (int d = 0; d < nDims; ++d)
            {
                force[link.nodeA][d] += link.partA*momentum[d];
                force[link.nodeB][d] += link.partB*momentum[d];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::linkOperator::set
(
    const UList<wallLink>& links,
    const scalar viscosity
)
{
    chain(links, viscosity);
    sortRows();

    entries_.clear();
    sources_.clear();
    start_.clear();
    for (const label row : rows_)
    {
        start_.append(entries_.size());
        for (label d = 0; d < nDims_; ++d)
        {
            sources_.append(matrix_.source(row)[d]);
        }
        for (label i = last_[row]; i >= 0; i = previous_[i])
        {
            entries_.append(unsorted_[i]);
        }
        last_[row] = -1;
    }
    start_.append(entries_.size());
    keepValues();
}


void Foam::fsi::linkOperator::setSources(const vectorField& v)
{
    forDims([&](auto n) { doSetSources<decltype(n)::value>(v); });
}


void Foam::fsi::linkOperator::startCorrection(const vectorField& v)
{
    forDims([&](auto n) { doStartCorrection<decltype(n)::value>(v); });
}


void Foam::fsi::linkOperator::setResiduals(const vectorField& v)
{
    forDims([&](auto n) { doSetResiduals<decltype(n)::value>(v); });
}


void Foam::fsi::linkOperator::addForce
(
    const scalar density,
    partialForces& force
) const
{
    forDims
    (
        [&](auto n) { doAddForce<decltype(n)::value>(density, force.mine()); }
    );
}


// ************************************************************************* //
