// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceGeometry.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Values per mesh face as a surface field; empty faces are left out
static void setSurfaceField
(
    surfaceScalarField& field,
    const scalarField& perFace
)
{
    const fvMesh& mesh = field.mesh();
    field.primitiveFieldRef() =
        SubField<scalar>(perFace, mesh.nInternalFaces());

    for (fvsPatchField<scalar>& pf : field.boundaryFieldRef())
    {
        const label start = pf.patch().start();
        forAll(pf, i)
        {
            pf[i] = perFace[start + i];
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::interfaceGeometry::setFields()
{
    setSurfaceField(openArea_, open_.openness());

    // Both cells fluid; those across are judged by their owners
    const fvMesh& mesh = grid().mesh();
    const boolList& fluid = open_.fluidCell();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        fluidFace_[facei] = fluid[own[facei]] && fluid[nei[facei]];
    }
    for (fvsPatchScalarField& pf : fluidFace_.boundaryFieldRef())
    {
        const labelUList& cells = pf.patch().faceCells();
        const label first = pf.patch().start() - mesh.nInternalFaces();
        forAll(pf, i)
        {
            pf[i] = fluid[cells[i]] && open_.fluidAcross()[first + i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::interfaceGeometry::interfaceGeometry
(
    const cartesianMesh& grid,
    const wallTreatment& wall
)
:
    open_(grid, wall),
    cutFaces_(open_, wall),
    filmLinks_(open_),
    cellWalls_(grid.mesh().nCells()),
    openFaces_(open_),
    films_(open_),
    patchWalls_(open_),
    openArea_
    (
        IOobject("openArea", nameOf(grid.mesh().time()), grid.mesh()),
        grid.mesh(),
        dimensionedScalar("value", dimless, 1)
    ),
    fluidFace_
    (
        IOobject("fluidFace", nameOf(grid.mesh().time()), grid.mesh()),
        grid.mesh(),
        dimensionedScalar("value", dimless, 1)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::interfaceGeometry::update
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    if (open_.update(levelSet, surfaces))
    {
        setFields();
    }
    cutFaces_.update(levelSet, surfaces);
    filmLinks_.update(levelSet, surfaces);
    cellWalls_.update
    (
        surfaces, cutFaces_.wallFaces(), cutFaces_.wallOrigins()
    );
    openFaces_.update(levelSet, cutFaces_.wallFaces());
    films_.update(levelSet, cutFaces_.wallFaces());
    patchWalls_.update(levelSet, surfaces);
}


// ************************************************************************* //
