// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallOperator.H"
#include "fetchAhead.H"
#include "partialForces.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::wallOperator::wallOperator(const interfaceGeometry& geometry)
:
    geometry_(geometry),
    nNodes_(0),
    nObjects_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::wallOperator::setCells()
{
    place_.setSize(geometry_.grid().mesh().nCells(), -1);
    for (const label celli : cells_)
    {
        place_[celli] = -1;
    }
    for (const wallFace& w : geometry_.wallFaces())
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0)
            {
                place_[celli] = 0;
            }
        }
    }
    cells_.clear();
    forAll(place_, celli)
    {
        if (place_[celli] >= 0)
        {
            place_[celli] = cells_.size();
            cells_.append(celli);
        }
    }
}


void Foam::fsi::wallOperator::setEntries()
{
    entries_.clear();
    setCells();
    perArea_.setSize(nObjects_);
    perArea_ = Zero;
    for (const cellWall& w : geometry_.surfaceParts())
    {
        const scalar area = mag(w.area);
        perArea_[w.place.object] += area;
        w.place.forPairs
        (
            [&](const label a, const scalar u, const label b, const scalar v)
            {
                entries_.append
                ({
                    place_[w.cell],
                    w.place.object,
                    a,
                    b,
                    u,
                    v,
                    area*(u + v),
                    w.area
                });
            }
        );
    }
    sumOverRanks(perArea_);
    perArea_ = 1/max(perArea_, VSMALL);
}


void Foam::fsi::wallOperator::setCuts(const surfaceSet& surfaces)
{
    cutNodes_.clear();
    cutAreas_.clear();
    cutPatches_.clear();
    cutFaces_.clear();
    const polyBoundaryMesh& patches =
        geometry_.grid().mesh().boundaryMesh();
    const auto add = [&](const label nodei, const wallFace& w, const scalar s)
    {
        vector area(Zero);
        area[w.dir] = (w.lower >= 0 ? s : -s)*w.area;
        cutNodes_.append(nodei);
        cutAreas_.append(area);
        const label patchi = patches.whichPatch(w.face);
        cutPatches_.append(patchi);
        cutFaces_.append(w.face - patches[patchi].start());
    };
    for (const wallFace& w : geometry_.outsideWalls())
    {
        if (w.place.nodes[0] >= 0)
        {
            for (label k = 0; k < 3 && w.place.nodes[k] >= 0; ++k)
            {
                add(w.place.nodes[k], w, w.place.weights[k]);
            }
            continue;
        }
        const label start = surfaces.pointStart()[w.place.object];
        const label end = surfaces.pointStart()[w.place.object + 1];
        for (label nodei = start; nodei < end; ++nodei)
        {
            add(nodei, w, scalar(1)/(end - start));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallOperator::update(const surfaceSet& surfaces)
{
    nNodes_ = surfaces.points().size();
    pointObject_ = surfaces.pointObject();
    pointStart_ = surfaces.pointStart();
    nObjects_ = surfaces.size();
    meanPressure_.setSize(nObjects_);

    setEntries();
    setCuts(surfaces);
    transposeSums(scalarField(cells_.size(), 1), uniformForce_);
    givenFlux_.setSize(nObjects_);
    givenFlux_ = Zero;
}


void Foam::fsi::wallOperator::setOutside
(
    const volScalarField& p,
    vectorField& force
)
{
    partialForces load(nNodes_), cut(nNodes_);
    forAll(cutNodes_, i)
    {
        const fvPatchScalarField& pp = p.boundaryField()[cutPatches_[i]];
        if (pp.fixesValue())
        {
            cut.mine()[cutNodes_[i]] -= cutAreas_[i];
            load.mine()[cutNodes_[i]] -= pp[cutFaces_[i]]*cutAreas_[i];
        }
    }
    uniformForce_ += cut.collect();
    force = load.collect();
}


void Foam::fsi::wallOperator::setGivenFlux
(
    const volScalarField& p,
    const volVectorField& U,
    const boolList& isFree,
    const vectorField& v
)
{
    givenFlux_ = Zero;
    forAll(cutNodes_, i)
    {
        if (!p.boundaryField()[cutPatches_[i]].fixesValue())
        {
            const label objecti = pointObject_[cutNodes_[i]];
            givenFlux_[objecti] +=
                cutAreas_[i]
              & (
                    isFree[objecti]
                  ? U.boundaryField()[cutPatches_[i]][cutFaces_[i]]
                  : v[cutNodes_[i]]
                );
        }
    }
    sumOverRanks(givenFlux_);
}


void Foam::fsi::wallOperator::gradientForce
(
    const vectorField& g,
    vectorField& f
) const
{
    const UList<wallFace>& faces = geometry_.wallFaces();
    const boolList& fluid = geometry_.fluidCell();
    const scalar h = geometry_.grid().spacing();

    // Closed area around each cell with its centre inside an object
    scalarField closed(cells_.size(), Zero);
    for (const wallFace& w : faces)
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0 && !fluid[celli])
            {
                closed[place_[celli]] += w.area;
            }
        }
    }

    partialForces part(nNodes_);
    vectorField& mine = part.mine();
    const scalarField& V = geometry_.grid().mesh().V();
    forAll(faces, i)
    {
        const wallFace& later = fetchedAhead(faces, i);
        fetchAhead(g[max(later.lower, 0)]);
        fetchAhead(g[max(later.upper, 0)]);
        fetchAhead(mine[later.place.nodes[0]]);

        const wallFace& w = faces[i];
        for (const label celli : {w.lower, w.upper})
        {
            if (celli < 0)
            {
                continue;
            }
            w.place.spread(mine, w.dir, 0.5*h*w.area*g[celli][w.dir]);
            if (!fluid[celli])
            {
                const scalar share = w.area/closed[place_[celli]];
                w.place.spread(mine, -share*V[celli]*g[celli]);
            }
        }
    }
    f.transfer(part.collect());
}


// ************************************************************************* //
