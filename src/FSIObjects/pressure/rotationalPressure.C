// SPDX-License-Identifier: GPL-3.0-or-later

#include "rotationalPressure.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Cells with fluid alone, none of whose faces a wall closes in part
static boolList wholeCells(const interfaceGeometry& geometry)
{
    boolList whole(geometry.fluidCell());
    const surfaceScalarField& open = geometry.openArea();
    const fvMesh& mesh = open.mesh();
    forAll(open, facei)
    {
        if (open[facei] < 1)
        {
            whole[mesh.owner()[facei]] = false;
            whole[mesh.neighbour()[facei]] = false;
        }
    }
    forAll(open.boundaryField(), patchi)
    {
        const fvsPatchScalarField& po = open.boundaryField()[patchi];
        const labelUList& cells = po.patch().faceCells();
        forAll(po, i)
        {
            if (po.coupled() && po[i] < 1)
            {
                whole[cells[i]] = false;
            }
        }
    }
    return whole;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addRotationalPart
(
    const interfaceGeometry& geometry,
    const scalarField& nu,
    const volScalarField& last,
    const scalar tau,
    volScalarField& p
)
{
    const cartesianMesh& grid = geometry.grid();
    surfaceScalarField flux
    (
        IOobject("flux", nameOf(p.mesh().time()), p.mesh()),
        p.mesh(),
        dimensionedScalar(dimless, Zero)
    );
    subtractGradient
    (
        geometry,
        volScalarField("change", p - last),
        grid.spacing()/grid.faceArea(),
        0,
        flux
    );
    scalarField laplacian(p.size(), Zero);
    subtractOutflow(flux, laplacian);

    const scalar perNu = tau/sqr(grid.spacing());
    const boolList whole(wholeCells(geometry));
    forAll(p, celli)
    {
        if (whole[celli])
        {
            p[celli] -= perNu*nu[celli]*laplacian[celli];
        }
    }
    p.correctBoundaryConditions();
}


// ************************************************************************* //
