// SPDX-License-Identifier: GPL-3.0-or-later

#include "eikonalStencil.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::eikonalStencil::setUpwind
(
    const cartesianBlock& block,
    const labelVector& ijk,
    const direction dir,
    const scalar side,
    const scalarField& phi,
    const boolList& accepted
)
{
    const label samplei = block.index(ijk);
    const label stride = block.stride(dir);
    const label n = block.n()[dir];

    // Neighbour with the smaller value
    upwind& result = upwinds_[dir];
    result = upwind();
    result.coefficient = 1/block.spacing();
    label step = 0;
    for (const label s : {-1, 1})
    {
        const label i = ijk[dir] + s;
        const label there = samplei + s*stride;
        if
        (
            i >= 0 && i < n && accepted[there]
         && side*phi[there] < result.base
        )
        {
            result.sample = there;
            result.base = side*phi[there];
            step = s;
        }
    }

    // The sample behind it
    const label i = ijk[dir] + 2*step;
    const label behind = samplei + 2*step*stride;
    if
    (
        order_ == 2 && step != 0 && i >= 0 && i < n
     && accepted[behind] && side*phi[behind] <= result.base
    )
    {
        result.base = (4*result.base - side*phi[behind])/3;
        result.coefficient *= 1.5;
    }
}


Foam::label Foam::fsi::eikonalStencil::highest() const
{
    label found = -1;
    forAll(upwinds_, dir)
    {
        const upwind& d = upwinds_[dir];
        if (d.sample >= 0 && (found < 0 || d.base > upwinds_[found].base))
        {
            found = dir;
        }
    }
    return found;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::eikonalStencil::eikonalStencil(const label order)
:
    order_(order),
    distance_(GREAT)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::eikonalStencil::solve
(
    const cartesianBlock& block,
    const labelVector& ijk,
    const scalarField& phi,
    const boolList& accepted
)
{
    const scalar side = phi[block.index(ijk)] > 0 ? 1 : -1;
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        setUpwind(block, ijk, dir, side, phi, accepted);
    }

    while (true)
    {
        // a x^2 + 2 b x + c = sum (coefficient (u - base))^2 - 1 with x = u
        // less the highest base. There is a root x >= 0, that is a solution
        // from which all neighbours in use are upwind, exactly if c <= 0
        const label last = highest();
        const scalar base = upwinds_[last].base;
        scalar a = 0, b = 0, c = -1;
        for (const upwind& d : upwinds_)
        {
            if (d.sample >= 0)
            {
                const scalar weight = sqr(d.coefficient);
                a += weight;
                b += weight*(base - d.base);
                c += weight*sqr(base - d.base);
            }
        }
        if (c <= 0)
        {
            distance_ = base - c/(b + sqrt(sqr(b) - a*c));
            return distance_;
        }
        upwinds_[last].sample = -1;
    }
}


void Foam::fsi::eikonalStencil::extend
(
    const label samplei,
    vectorField& velocity,
    labelList& object
) const
{
    // The upwind differences are the weights
    FixedList<scalar, 3> weight(0.0);
    label heaviest = -1;
    forAll(upwinds_, dir)
    {
        const upwind& d = upwinds_[dir];
        if (d.sample >= 0)
        {
            weight[dir] = d.coefficient*(distance_ - d.base);
            if (heaviest < 0 || weight[dir] > weight[heaviest])
            {
                heaviest = dir;
            }
        }
    }

    object[samplei] = object[upwinds_[heaviest].sample];
    scalar sumWeight = 0;
    vector sum(Zero);
    forAll(upwinds_, dir)
    {
        const label from = upwinds_[dir].sample;
        if (from >= 0 && object[from] == object[samplei])
        {
            sumWeight += weight[dir];
            sum += weight[dir]*velocity[from];
        }
    }
    velocity[samplei] = sum/sumWeight;
}


// ************************************************************************* //
