// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceStretches.H"
#include "membraneTriangle.H"
#include "population.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::faceStretches::faceStretches
(
    const population& objects,
    const label objecti
)
{
    const shapeTemplate& shape = objects.shape(objects.objectGroup(objecti));
    const surfaceSet& surfaces = objects.surfaces();
    const SubList<point> x
    (
        surfaces.points(),
        shape.nBoundaryNodes(),
        surfaces.pointStart()[objecti]
    );
    larger.resize(shape.faces().size());
    smaller.resize(larger.size());
    forAll(larger, i)
    {
        membraneTriangle(shape.faces()[i], shape.points()).stretches
        (
            x, larger[i], smaller[i]
        );
    }
}


// ************************************************************************* //
