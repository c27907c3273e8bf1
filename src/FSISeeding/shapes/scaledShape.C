// SPDX-License-Identifier: GPL-3.0-or-later

#include "scaledShape.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::scaledShape::scaledShape
(
    const shape& original,
    const scalar factor,
    const direction nDims
)
:
    original_(original),
    factor_(factor),
    nDims_(nDims)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::scaledShape::mesh
(
    const scalar nodeSpacing,
    const meshGrading& grading,
    const bool filled
) const
{
    shapeMesh mesh(original_.mesh(nodeSpacing/factor_, grading, filled));
    mesh.points *= factor_;
    return mesh;
}


Foam::scalar Foam::fsi::scaledShape::volume() const
{
    return std::pow(factor_, nDims_)*original_.volume();
}


Foam::boundBox Foam::fsi::scaledShape::bounds() const
{
    const boundBox box(original_.bounds());
    return boundBox(factor_*box.min(), factor_*box.max());
}


// ************************************************************************* //
