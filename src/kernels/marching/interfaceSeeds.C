// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceSeeds.H"
#include "blockInterpolation.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::interfaceSeeds::findLinear
(
    const cartesianBlock& block,
    const scalarField& phi,
    const labelVector& ijk,
    point& nearest
) const
{
    const label samplei = block.index(ijk);
    const scalar here = phi[samplei];
    nearest = block.position(ijk);
    if (here == 0)
    {
        return true;
    }

    // The plane cuts the lines through the sample at offset[dir]: its nearest
    // point is (1/offset)/|1/offset|^2
    vector inverse(Zero);
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        scalar shortest = GREAT;
        for (const label side : {-1, 1})
        {
            const label i = ijk[dir] + side;
            if (i < 0 || i >= block.n()[dir])
            {
                continue;
            }
            const scalar there = phi[samplei + side*block.stride(dir)];
            if ((here > 0) != (there > 0))
            {
                const scalar part = max(here/(here - there), SMALL);
                const scalar d = block.spacing()*part;
                if (d < shortest)
                {
                    shortest = d;
                    inverse[dir] = side/d;
                }
            }
        }
    }

    if (inverse == vector::zero)
    {
        return false;
    }
    nearest += inverse/magSqr(inverse);
    return true;
}


bool Foam::fsi::interfaceSeeds::findCubic
(
    const cartesianBlock& block,
    const scalarField& phi,
    const point& sample,
    point& nearest
) const
{
    const label maxIterations = 30;
    const scalar tolerance = 1e-9*block.spacing();
    const scalar farthest = 1.5*block.spacing();

    nearest = sample;
    for (label iteration = 0; iteration < maxIterations; ++iteration)
    {
        scalar value;
        vector gradient;
        if (!interpolateCubic(block, phi, nearest, value, gradient))
        {
            return false;
        }
        gradient /= max(magSqr(gradient), VSMALL);

        // Towards the zero, and along it towards the foot of the sample
        const vector offset(sample - nearest);
        const vector step
        (
           -value*gradient + offset
          - (offset & gradient)*gradient/max(magSqr(gradient), VSMALL)
        );
        nearest += step;
        if (!(magSqr(nearest - sample) < sqr(farthest)))
        {
            return false;
        }
        if (magSqr(step) < sqr(tolerance))
        {
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::interfaceSeeds::update
(
    const cartesianBlock& block,
    const scalarField& phi
)
{
    samples_.clear();
    distance_.clear();

    point linear, cubic;
    labelVector ijk;
    for (ijk.z() = 0; ijk.z() < block.n().z(); ++ijk.z())
    {
        for (ijk.y() = 0; ijk.y() < block.n().y(); ++ijk.y())
        {
            for (ijk.x() = 0; ijk.x() < block.n().x(); ++ijk.x())
            {
                if (!findLinear(block, phi, ijk, linear))
                {
                    continue;
                }
                const point sample(block.position(ijk));
                const point& nearest =
                    findCubic(block, phi, sample, cubic) ? cubic : linear;
                const scalar distance = mag(nearest - sample);
                const label samplei = block.index(ijk);
                samples_.append(samplei);
                distance_.append(phi[samplei] > 0 ? distance : -distance);
            }
        }
    }
}


// ************************************************************************* //
