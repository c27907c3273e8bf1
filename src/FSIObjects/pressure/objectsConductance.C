// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsConductance.H"
#include "fetchAhead.H"
#include "mathematicalConstants.H"
#include "openfoamMesh.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::fsi::objectsConductance::inside() const
{
    const boolList& active = geometry_.activeCell();
    const levelSetUpdate& levelSet = objects_.levelSet();
    const labelList& place = objects_.grid().haloIndex();

    labelList result(active.size(), label(fluid));
    forAll(result, celli)
    {
        if (!active[celli])
        {
            const label o = levelSet.objectAt(place[celli]);
            const label objecti = o < 0 ? o : objects_.surfaces().original(o);
            result[celli] =
                objecti >= 0 && bodies_.movesFreely(objecti)
              ? objecti
              : label(insulator);
        }
    }
    return result;
}


Foam::scalarField Foam::fsi::objectsConductance::interiorFactor() const
{
    using constant::mathematical::pi;
    const cartesianMesh& grid = objects_.grid();
    const scalar h = grid.spacing();

    scalarField factor(bodies_.nHeld(), Zero);
    forAll(factor, objecti)
    {
        const shapeTemplate& shape =
            bodies_.shape(bodies_.objectGroup(objecti));
        const scalar S = bodies_.surfaces().surfaceArea(objecti);
        const scalar P = grid.nDims() == 2 ? S : std::sqrt(pi*S);
        const scalar reach =
            tau_*std::sqrt(shape.youngsModulus()/shape.density());
        factor[objecti] =
            max(0.56*P*h/sqr(reach + h), 1.0)
           *min(objects_.fluid().density/shape.density(), 1.0);
    }
    return factor;
}


void Foam::fsi::objectsConductance::setInterior
(
    const cellObjects& objects,
    faceValues& conductance
) const
{
    const cartesianMesh& grid = objects_.grid();
    const scalar face =
        tau_*grid.faceArea()/grid.spacing();
    const label nInternal = grid.mesh().nInternalFaces();
    const scalarField factor(interiorFactor());
    grid.forFaces([&](const label facei)
    {
        const label own = objects.own(facei);
        const bool same = own >= 0 && own == objects.neighbour(facei);
        conductance.face[facei] = same ? face*factor[own] : 0;
        if (same && facei < nInternal)
        {
            conductance.faces.append(facei);
        }
    });
}


void Foam::fsi::objectsConductance::lowerInFilms(scalarField& d) const
{
    const fvMesh& mesh = objects_.grid().mesh();
    boolList lowered(d.size(), false);
    const auto lower = [&](const label celli)
    {
        const label at = walls_.place(celli);
        if (at >= 0 && !lowered[at])
        {
            d[at] *= inFilms;
            lowered[at] = true;
        }
    };
    for (const filmFace& film : geometry_.films().faces())
    {
        lower(mesh.faceOwner()[film.face]);
        if (mesh.isInternalFace(film.face))
        {
            lower(mesh.faceNeighbour()[film.face]);
        }
    }
}


void Foam::fsi::objectsConductance::addWalls
(
    const cellObjects& objects,
    const vectorField& mobility,
    faceValues& conductance
) const
{
    const UList<wallFace>& faces = geometry_.wallFaces();
    const label nInternal = objects_.grid().mesh().nInternalFaces();

    // Closed area of each cell at walls towards the inside
    scalarField d(estimate*diagonal(mobility));
    lowerInFilms(d);
    scalarField inner(d.size(), Zero), all(d.size(), Zero);
    boolList reaches(faces.size());
    forAll(faces, i)
    {
        const wallFace& w = faces[i];
        reaches[i] =
            !(w.lower >= 0 && w.upper >= 0)
         && (objects.own(w.face) >= 0 || objects.neighbour(w.face) >= 0);
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0)
            {
                inner[walls_.place(celli)] += reaches[i] ? w.area : 0;
                all[walls_.place(celli)] += w.area;
            }
        }
    }
    forAll(faces, i)
    {
        const label later = fetchedAhead(faces, i).face;
        fetchAhead(conductance.face[later]);
        const wallFace& w = faces[i];
        const bool thin =
            w.lower >= 0 && w.upper >= 0
         && inner[walls_.place(w.lower)] + inner[walls_.place(w.upper)] == 0;
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0 && (thin || reaches[i]))
            {
                const label at = walls_.place(celli);
                const scalar area = (thin ? all : inner)[at];
                conductance.add(w.face, w.area*d[at]/area, nInternal);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectsConductance::objectsConductance
(
    const fsiObjects& objects,
    const interfaceGeometry& geometry,
    const wallOperator& walls
)
:
    objects_(objects),
    bodies_(objects.bodies()),
    geometry_(geometry),
    walls_(walls),
    tau_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::objectsConductance::faceValues
Foam::fsi::objectsConductance::conductance(const stepLength& step)
{
    tau_ = step.tau;
    const fvMesh& mesh = objects_.grid().mesh();
    const label nInternal = mesh.nInternalFaces();
    cellObjects objects
    {
        mesh.faceOwner(),
        mesh.faceNeighbour(),
        inside(),
        labelList()
    };
    // Ranks know each other's objects by their ids
    labelList ids(objects.object);
    for (label& object : ids)
    {
        object = object < 0 ? object : bodies_.objectId(object);
    }
    swapCoupledCells(mesh, ids, objects.across);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (label i = 0; i < patch.size() && patch.coupled(); ++i)
        {
            label& object = objects.across[patch.start() - nInternal + i];
            object = object < 0 ? object : bodies_.findObject(object);
        }
    }

    faceValues g;
    g.face.setSize(mesh.nFaces());
    setInterior(objects, g);
    const vectorField mobility(nodeMobility());
    addWalls(objects, mobility, g);
    const auto conducts = [&](const label facei, const scalar ofFilm)
    {
        g.add(facei, ofFilm, nInternal);
    };
    walls_.forFilmConductances(mobility, conducts);

    // The rank of the cell inside has no wall
    SubList<scalar> boundary(g.face, mesh.nFaces() - nInternal, nInternal);
    syncCoupledFaces(mesh, boundary, maxEqOp<scalar>());
    return g;
}


void Foam::fsi::objectsConductance::add
(
    const faceValues& conductance,
    const scalar sign,
    fvScalarMatrix& matrix
)
{
    const labelUList& own = matrix.lduAddr().lowerAddr();
    const labelUList& nei = matrix.lduAddr().upperAddr();
    scalarField& diagonal = matrix.diag();
    scalarField& upper = matrix.upper();
    for (const label facei : conductance.faces)
    {
        const scalar g = sign*conductance.face[facei];
        upper[facei] -= g;
        diagonal[own[facei]] += g;
        diagonal[nei[facei]] += g;
    }
    forAll(matrix.psi().mesh().boundary(), patchi)
    {
        const fvPatch& patch = matrix.psi().mesh().boundary()[patchi];
        for (label i = 0; i < patch.size() && patch.coupled(); ++i)
        {
            const scalar g = sign*conductance.face[patch.start() + i];
            boundaryCoeffsOf(matrix)[patchi][i] += g;
            diagonal[patch.faceCells()[i]] += g;
        }
    }
}


// ************************************************************************* //
