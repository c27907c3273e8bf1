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
    const pointField& x = surfaces.points();
    const label start = surfaces.faceStart()[objecti];
    larger.resize(shape.faces().size());
    smaller.resize(larger.size());
    forAll(larger, i)
    {
        const surfaceFace& f = surfaces.faces()[start + i];
        membraneTriangle(shape.faces()[i], shape.points()).stretches
        (
            x[f[0]], x[f[1]], x[f[2]], larger[i], smaller[i]
        );
    }
}


// ************************************************************************* //
