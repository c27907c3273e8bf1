// SPDX-License-Identifier: GPL-3.0-or-later

#include "responseMatrix.H"
#include "elasticMatrix.H"
#include "membraneMatrix.H"

// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::responseMatrix> Foam::fsi::responseMatrix::New
(
    const shapeTemplate& shape
)
{
    if (shape.membrane())
    {
        return autoPtr<responseMatrix>(new membraneMatrix(shape));
    }
    return autoPtr<responseMatrix>(new elasticMatrix(shape));
}


// ************************************************************************* //
