// SPDX-License-Identifier: GPL-3.0-or-later

#include "shortWaves.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::shortWaves::friction
(
    const scalar viscosity,
    const scalar thickness
)
{
    return constant::mathematical::twoPi/64*viscosity*thickness;
}


Foam::List<Foam::fsi::shortWaves::fourNodes> Foam::fsi::shortWaves::rows
(
    const shapeTemplate& shape
)
{
    labelList next(shape.nBoundaryNodes());
    for (const auto& face : shape.faces())
    {
        next[face[0]] = face[1];
    }
    List<fourNodes> result(next.size());
    forAll(result, nodei)
    {
        label last = nodei;
        for (label& node : result[nodei])
        {
            node = last;
            last = next[last];
        }
    }
    return result;
}


void Foam::fsi::shortWaves::addForce
(
    const fourNodes& row,
    const label first,
    const scalar friction,
    const vectorField& v,
    vectorField& force
)
{
    vector wave(Zero);
    forAll(row, i)
    {
        wave += difference[i]*v[first + row[i]];
    }
    forAll(row, i)
    {
        force[first + row[i]] -= friction*difference[i]*wave;
    }
}


// ************************************************************************* //
