// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsConductance.H"
#include "mathematicalConstants.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::fsi::objectsConductance::inside() const
{
    const boolList& active = system_.geometry.activeCell();
    const labelList& nearest = system_.levelSet->object();
    const labelList& place = system_.geometry.haloIndex();

    labelList result(active.size(), label(fluid));
    forAll(result, celli)
    {
        if (!active[celli])
        {
            const label o = nearest[place[celli]];
            const label objecti = o < 0 ? o : system_.surfaces().original(o);
            result[celli] =
                objecti >= 0 && system_.objects.free(objecti)
              ? objecti
              : label(insulator);
        }
    }
    return result;
}


void Foam::fsi::objectsConductance::setInterior
(
    const labelList& own,
    const labelList& neighbour,
    scalarField& conductance
) const
{
    using constant::mathematical::pi;
    const cartesianMesh& grid = system_.grid;
    const scalar h = grid.spacing();
    const scalar face =
        system_.deltaT()*pow(h, grid.nDims() - 2)*grid.thickness();

    scalarField factor(system_.objects.size(), Zero);
    forAll(factor, objecti)
    {
        const shapeTemplate& shape =
            system_.objects.shape(system_.objects.objectGroup(objecti));
        const scalar S = system_.objects.surfaces().surfaceArea(objecti);
        const scalar P = grid.nDims() == 2 ? S : std::sqrt(pi*S);
        const scalar reach =
            system_.deltaT()*std::sqrt(shape.youngsModulus()/shape.density());
        factor[objecti] =
            max(0.56*P*h/sqr(reach + h), 1.0)
           *min(system_.fluidDensity/shape.density(), 1.0);
    }
    grid.forFaces([&](const label facei)
    {
        const bool same = own[facei] >= 0 && own[facei] == neighbour[facei];
        conductance[facei] = same ? face*factor[own[facei]] : 0;
    });
}


void Foam::fsi::objectsConductance::addWalls
(
    const labelList& own,
    const labelList& neighbour,
    scalarField& conductance
) const
{
    const auto reaches = [&](const wallFace& w)
    {
        return own[w.face] >= 0 || neighbour[w.face] >= 0;
    };
    const scalarField d(estimate*diagonal());
    const UList<wallFace>& faces = system_.geometry.wallFaces();

    // Closed area of each cell towards the inside
    scalarField inner(d.size(), Zero), all(d.size(), Zero);
    for (const wallFace& w : faces)
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0)
            {
                inner[celli] += reaches(w) ? w.area : 0;
                all[celli] += w.area;
            }
        }
    }
    for (const wallFace& w : faces)
    {
        const bool both = w.lower >= 0 && w.upper >= 0;
        const bool thin = both && inner[w.lower] + inner[w.upper] == 0;
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0 && (thin || reaches(w)))
            {
                conductance[w.face] +=
                    w.area*d[celli]/(thin ? all : inner)[celli];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectsConductance::objectsConductance(const fsiSystem& system)
:
    system_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField>
Foam::fsi::objectsConductance::conductance() const
{
    const fvMesh& mesh = system_.grid.mesh();
    const label nInternal = mesh.nInternalFaces();
    const labelList object(inside());

    labelList own(mesh.nFaces()), neighbour(mesh.nFaces());
    labelList across;
    swapCoupledCells(mesh, object, across);
    system_.grid.forFaces([&](const label facei)
    {
        own[facei] = object[mesh.faceOwner()[facei]];
        neighbour[facei] =
            facei < nInternal
          ? object[mesh.faceNeighbour()[facei]]
          : across[facei - nInternal];
    });

    auto tg = tmp<scalarField>::New(mesh.nFaces());
    scalarField& g = tg.ref();
    setInterior(own, neighbour, g);
    addWalls(own, neighbour, g);

    // The rank of the cell inside has no wall
    SubList<scalar> boundary(g, mesh.nFaces() - nInternal, nInternal);
    syncTools::syncBoundaryFaceList(mesh, boundary, maxEqOp<scalar>());
    return tg;
}


void Foam::fsi::objectsConductance::addTo(fvScalarMatrix& matrix) const
{
    const fvMesh& mesh = system_.grid.mesh();
    const scalarField g(conductance());

    scalarField& diagonal = matrix.diag();
    scalarField& upper = matrix.upper();
    forAll(upper, facei)
    {
        upper[facei] -= g[facei];
        diagonal[mesh.faceOwner()[facei]] += g[facei];
        diagonal[mesh.faceNeighbour()[facei]] += g[facei];
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        for (label i = 0; i < patch.size() && patch.coupled(); ++i)
        {
            matrix.boundaryCoeffs()[patchi][i] += g[patch.start() + i];
            diagonal[patch.faceCells()[i]] += g[patch.start() + i];
        }
    }
}


// ************************************************************************* //
