// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscosityContrast.H"
#include "fluidViscosity.H"
#include "insideFraction.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Fatal if the viscosity inside a shape is far from that around it
static void checkContrast
(
    const shapeTemplate& shape,
    const scalar inside,
    const scalar around
)
{
    // 0 around: a generalised Newtonian fluid, of which nothing is known yet
    const scalar most = 1e4;
    if (around > 0 && (inside > most*around || inside*most < around))
    {
        FatalErrorInFunction
            << "Entry 'innerViscosity' of the material in constant/fsiObjects/"
            << shape.name() << " is " << inside << " Pa s but must be from "
            << around/most << " to " << most*around << " Pa s, " << 1/most
            << " to " << most << " times that of the fluid around: beyond it"
            << " the flow is as at these bounds, but membranes would ask for"
            << " far shorter steps" << exit(FatalError);
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::viscosityContrast::moreInside
(
    const shapeTemplate& shape
) const
{
    const scalar inside = shape.sheet()->innerViscosity;
    return inside > 0 ? inside/fluid_.density - fluid_.viscosity : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::viscosityContrast::viscosityContrast
(
    const faceLattice& faces,
    const fluidProperties& fluid
)
:
    faces_(faces),
    fluid_(fluid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::viscosityContrast::wanted
(
    const population& bodies,
    const fluidProperties& fluid
)
{
    const scalar around = fluid.dynamicViscosity();
    bool any = false;
    for (const bodyGroup& group : bodies.groups())
    {
        const scalar inside =
            group.hasWalls() ? 0 : group.shape().sheet()->innerViscosity;
        if (inside > 0 && mag(inside - around) > 1e-9*around)
        {
            checkContrast(group.shape(), inside, around);
            any = true;
        }
    }
    return any;
}


void Foam::fsi::viscosityContrast::update
(
    const population& bodies,
    fluidViscosity& viscosity
) const
{
    scalar least = 0;
    for (const bodyGroup& group : bodies.groups())
    {
        if (!group.hasWalls())
        {
            least = min(least, moreInside(group.shape()));
        }
    }
    const staggeredLattice& lattice = faces_.lattice();
    insideFraction scan(lattice);
    scalarField fraction(lattice.size(), Zero), fluidity(fraction);
    const surfaceSet& surfaces = bodies.surfaces();
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (surfaces.hasWalls(objecti))
        {
            continue;
        }
        const shapeTemplate& shape = bodies.shape(bodies.objectGroup(objecti));
        if (viscosity.hasLaw() && shape.sheet()->innerViscosity <= 0)
        {
            continue;
        }
        const label start = surfaces.pointStart()[objecti];
        scan.add
        (
            SubList<point>(surfaces.points(), shape.nNodes(), start),
            shape.faces(),
            1/(fluid_.viscosity + moreInside(shape)),
            fraction,
            fluidity
        );
    }
    const labelUList& place = faces_.placeOfCells();
    scalarField insideCells(place.size()), fluidityInCells(place.size());
    forAll(place, celli)
    {
        const scalar inside = max(fraction[place[celli]], scalar(1));
        insideCells[celli] = fraction[place[celli]]/inside;
        fluidityInCells[celli] = fluidity[place[celli]]/inside;
    }
    viscosity.setInside(insideCells, fluidityInCells, least);
}


// ************************************************************************* //
