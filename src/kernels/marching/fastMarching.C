// SPDX-License-Identifier: GPL-3.0-or-later

#include "fastMarching.H"
#include "error.H"

#include <algorithm>
#include <functional>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fastMarching::check
(
    const cartesianBlock& block,
    const levelSetFields& fields,
    const label halo
) const
{
    if (halo != noNeighbours && bandWidth_ > (halo + SMALL)*block.spacing())
    {
        FatalErrorInFunction
            << "The band of " << bandWidth_/block.spacing()
            << " samples is wider than the halo of " << halo << " samples"
            << exit(FatalError);
    }
    if (fields.seeds.empty())
    {
        FatalErrorInFunction
            << "No sample to start from: the block holds no interface"
            << exit(FatalError);
    }
    if
    (
        fields.phi.size() != block.size()
     || fields.velocity.size() != block.size()
     || fields.object.size() != block.size()
    )
    {
        FatalErrorInFunction
            << "The fields have " << fields.phi.size() << ", "
            << fields.velocity.size() << " and " << fields.object.size()
            << " samples but the block has " << block.size()
            << exit(FatalError);
    }
    forAll(fields.phi, samplei)
    {
        if (!std::isfinite(fields.phi[samplei]))
        {
            FatalErrorInFunction
                << "The level set is " << fields.phi[samplei] << " at "
                << block.position(samplei)
                << exit(FatalError);
        }
    }
    for (const label samplei : fields.seeds)
    {
        if (!std::isfinite(magSqr(fields.velocity[samplei])))
        {
            FatalErrorInFunction
                << "The velocity is " << fields.velocity[samplei] << " at "
                << block.position(samplei)
                << exit(FatalError);
        }
    }
}


void Foam::fsi::fastMarching::updateNeighbours
(
    const cartesianBlock& block,
    const label samplei,
    const scalarField& phi
)
{
    const labelVector ijk(block.ijk(samplei));
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        for (const label s : {-1, 1})
        {
            labelVector there(ijk);
            there[dir] += s;
            if (there[dir] < 0 || there[dir] >= block.n()[dir])
            {
                continue;
            }
            const label i = block.index(there);
            if (accepted_[i])
            {
                continue;
            }
            const scalar distance =
                stencil_.solve(block, there, phi, accepted_);
            if (distance < distance_[i])
            {
                distance_[i] = distance;
                push(distance, i);
            }
        }
    }
}


void Foam::fsi::fastMarching::accept
(
    const cartesianBlock& block,
    const label samplei,
    levelSetFields& fields
)
{
    const scalar distance =
        stencil_.solve(block, block.ijk(samplei), fields.phi, accepted_);
    stencil_.extend(samplei, fields.velocity, fields.object);

    fields.phi[samplei] = fields.phi[samplei] > 0 ? distance : -distance;
    accepted_[samplei] = true;
    reached_.append(samplei);
    updateNeighbours(block, samplei, fields.phi);
}


void Foam::fsi::fastMarching::push(const scalar distance, const label samplei)
{
    heap_.append(candidate(distance, samplei));
    std::push_heap(heap_.begin(), heap_.end(), std::greater<candidate>());
}


Foam::fsi::fastMarching::candidate Foam::fsi::fastMarching::pop()
{
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<candidate>());
    return heap_.remove();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fastMarching::fastMarching
(
    const scalar bandWidth,
    const label order
)
:
    bandWidth_(bandWidth),
    stencil_(order)
{
    if (!(bandWidth > 0))
    {
        FatalErrorInFunction
            << "The width of the band is " << bandWidth << " but must be > 0"
            << exit(FatalError);
    }
    if (order != 1 && order != 2)
    {
        FatalErrorInFunction
            << "The order is " << order << " but must be 1 or 2"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fastMarching::march
(
    const cartesianBlock& block,
    levelSetFields& fields,
    const label halo
)
{
    check(block, fields, halo);

    accepted_.setSize(block.size());
    accepted_ = false;
    distance_.setSize(block.size());
    distance_ = bandWidth_;
    heap_.clear();
    reached_ = fields.seeds;

    for (const label samplei : reached_)
    {
        accepted_[samplei] = true;
    }
    for (const label samplei : fields.seeds)
    {
        updateNeighbours(block, samplei, fields.phi);
    }

    while (!heap_.empty())
    {
        const label samplei = pop().second;
        if (!accepted_[samplei])
        {
            accept(block, samplei, fields);
        }
    }

    forAll(accepted_, samplei)
    {
        if (!accepted_[samplei])
        {
            fields.phi[samplei] =
                fields.phi[samplei] > 0 ? bandWidth_ : -bandWidth_;
            fields.velocity[samplei] = Zero;
            fields.object[samplei] = -1;
        }
    }
}


// ************************************************************************* //
