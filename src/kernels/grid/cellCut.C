// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellCut.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Components smaller than this would lose digits in the quotient
const scalar smallest = 1e-3;

scalar powerOfPositive(const scalar x, const label n)
{
    return x <= 0 ? 0 : n == 2 ? x*x : x*x*x;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::closedPartOfCell
(
    const vector& normal,
    const scalar distance,
    const direction nDims
)
{
    const scalar length = mag(normal) + VSMALL;
    vector m(Zero);
    scalar product = nDims == 2 ? 2 : 6;
    for (direction i = 0; i < nDims; ++i)
    {
        m[i] = max(mag(normal[i])/length, smallest);
        product *= m[i];
    }
    const scalar a = 0.5*(m.x() + m.y() + m.z()) - mag(distance);
    scalar part = powerOfPositive(a, nDims);
    for (direction i = 0; i < nDims; ++i)
    {
        part -= powerOfPositive(a - m[i], nDims);
        for (direction j = 0; j < i && nDims == 3; ++j)
        {
            part += powerOfPositive(a - m[i] - m[j], nDims);
        }
    }
    part /= product;
    return distance > 0 ? part : 1 - part;
}


// ************************************************************************* //
