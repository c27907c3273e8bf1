// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscosityContrast.H"
#include "fvcGrad.H"
#include "insideFraction.H"
#include "openLaplacian.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::viscosityContrast::viscosityContrast
(
    const population& bodies,
    const interfaceGeometry& geometry,
    const faceLattice& faces,
    const fluidProperties& fluid
)
:
    geometry_(geometry),
    faces_(faces),
    fluid_(fluid),
    more_
    (
        IOobject
        (
            "moreViscosity",
            nameOf(geometry.grid().mesh().time()),
            geometry.grid().mesh()
        ),
        geometry.grid().mesh(),
        dimensionedScalar(dimVelocity*dimLength, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    moreAtFaces_
    (
        IOobject
        (
            "moreViscosityAtFaces",
            nameOf(geometry.grid().mesh().time()),
            geometry.grid().mesh()
        ),
        geometry.grid().mesh(),
        dimensionedScalar(dimVelocity*dimLength, Zero)
    ),
    least_(0)
{
    for (const bodyGroup& group : bodies.groups())
    {
        if (!group.hasWalls())
        {
            least_ = min(least_, moreInside(group.shape()));
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::viscosityContrast::moreInside
(
    const shapeTemplate& shape
) const
{
    const scalar inside = shape.sheet()->innerViscosity;
    return inside > 0 ? inside/fluid_.density - fluid_.viscosity : 0;
}


void Foam::fsi::viscosityContrast::setFaces()
{
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    const labelUList& own = more_.mesh().owner();
    const labelUList& nei = more_.mesh().neighbour();
    forAll(moreAtFaces_, facei)
    {
        moreAtFaces_[facei] =
            fluidFace[facei]*0.5*(more_[own[facei]] + more_[nei[facei]]);
    }
    forAll(more_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pm = more_.boundaryField()[patchi];
        const scalarField inside(pm.patchInternalField());
        moreAtFaces_.boundaryFieldRef()[patchi] ==
            fluidFace.boundaryField()[patchi]
           *(
                pm.coupled()
              ? 0.5*(inside + pm.patchNeighbourField())
              : tmp<scalarField>(inside)
            );
    }
}


void Foam::fsi::viscosityContrast::addTransposed(fvVectorMatrix& UEqn) const
{
    const cartesianMesh& grid = geometry_.grid();
    const fvMesh& mesh = more_.mesh();
    const volVectorField& U = UEqn.psi();
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    const boolList& inFluid = geometry_.fluidCell();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    vectorField& source = UEqn.source();
    const vectorField& area = mesh.faceAreas();
    for (direction d = 0; d < grid.nDims(); ++d)
    {
        const tmp<volVectorField> tgradient
        (
            fvc::grad(U.component(d), "grad(" + U.name() + ')')
        );
        const volVectorField& gradient = tgradient();
        forAll(moreAtFaces_, facei)
        {
            const scalar more = moreAtFaces_[facei] - least_*fluidFace[facei];
            if (more != 0 && grid.faceDirection(facei) == d)
            {
                const label a = own[facei], b = nei[facei];
                const vector force
                (
                    0.5*area[facei][d]*more*(gradient[a] + gradient[b])
                );
                source[a] += inFluid[a] ? force : vector(Zero);
                source[b] -= inFluid[b] ? force : vector(Zero);
            }
        }
        forAll(moreAtFaces_.boundaryField(), patchi)
        {
            const fvsPatchScalarField& pm =
                moreAtFaces_.boundaryField()[patchi];
            const fvPatchVectorField& pg = gradient.boundaryField()[patchi];
            const vectorField outside
            (
                pg.coupled()
              ? 0.5*(pg.patchInternalField() + pg.patchNeighbourField())
              : tmp<vectorField>(pg)
            );
            const scalarField& open = fluidFace.boundaryField()[patchi];
            const label start = pm.patch().start();
            forAll(pm, i)
            {
                const label celli = pm.patch().faceCells()[i];
                if (grid.faceDirection(start + i) == d && inFluid[celli])
                {
                    source[celli] +=
                        area[start + i][d]*(pm[i] - least_*open[i])*outside[i];
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::viscosityContrast::wanted
(
    const population& bodies,
    const fluidProperties& fluid
)
{
    for (const bodyGroup& group : bodies.groups())
    {
        const scalar inside =
            group.hasWalls() ? 0 : group.shape().sheet()->innerViscosity;
        if
        (
            inside > 0
         && mag(inside - fluid.dynamicViscosity())
          > 1e-9*fluid.dynamicViscosity()
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::fsi::viscosityContrast::update(const population& bodies)
{
    const staggeredLattice& lattice = faces_.lattice();
    insideFraction scan(lattice);
    scalarField fraction(lattice.size(), Zero), more(fraction);
    const surfaceSet& surfaces = bodies.surfaces();
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (surfaces.hasWalls(objecti))
        {
            continue;
        }
        const shapeTemplate& shape = bodies.shape(bodies.objectGroup(objecti));
        const label start = surfaces.pointStart()[objecti];
        scan.add
        (
            SubList<point>(surfaces.points(), shape.nNodes(), start),
            shape.faces(),
            moreInside(shape),
            fraction,
            more
        );
    }
    const labelUList& place = faces_.placeOfCells();
    forAll(place, celli)
    {
        const scalar inside = max(fraction[place[celli]], scalar(1));
        more_[celli] = more[place[celli]]/inside;
    }
    more_.correctBoundaryConditions();
    setFaces();
}


void Foam::fsi::viscosityContrast::add(fvVectorMatrix& UEqn) const
{
    const fvMesh& mesh = more_.mesh();
    const scalar perLength =
        geometry_.grid().faceArea()/geometry_.grid().spacing();
    scalarField& diagonal = UEqn.diag();
    scalarField& upper = UEqn.upper();
    scalarField& lower = UEqn.lower();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(upper, facei)
    {
        const scalar g = perLength*moreAtFaces_[facei];
        if (g != 0)
        {
            upper[facei] -= g;
            lower[facei] -= g;
            diagonal[own[facei]] += g;
            diagonal[nei[facei]] += g;
        }
    }
    forAll(moreAtFaces_.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pm = moreAtFaces_.boundaryField()[patchi];
        addPatchDiffusion(patchi, pm*pm.patch().magSf(), UEqn);
    }

    addTransposed(UEqn);
}


// ************************************************************************* //
