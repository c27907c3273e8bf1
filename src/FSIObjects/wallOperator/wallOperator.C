// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallOperator.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::wallOperator::wallOperator(const interfaceGeometry& geometry)
:
    geometry_(geometry),
    nNodes_(0),
    nObjects_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::wallOperator::transposeSums
(
    const scalarField& p,
    vectorField& force
) const
{
    const UList<wallFace>& faces = geometry_.wallFaces();

    force.setSize(nNodes_);
    force = Zero;
    meanPressure_ = 0;
    forAll(faces, i)
    {
        const wallFace& w = faces[i];
        const scalar lower = w.lower < 0 ? 0 : p[w.lower];
        const scalar upper = w.upper < 0 ? 0 : p[w.upper];
        w.place.spread(force, w.dir, w.area*(lower - upper));
        meanPressure_[w.place.object] += share_[i]*(lower + upper);
    }

    if (Pstream::parRun())
    {
        // One exchange for both: the means behind the forces
        exchange_.setSize(nNodes_ + nObjects_);
        SubList<vector>(exchange_, nNodes_) = force;
        forAll(meanPressure_, objecti)
        {
            exchange_[nNodes_ + objecti] =
                vector(meanPressure_[objecti], 0, 0);
        }
        sumOverRanks(exchange_);
        force = SubList<vector>(exchange_, nNodes_);
        forAll(meanPressure_, objecti)
        {
            meanPressure_[objecti] = exchange_[nNodes_ + objecti].x();
        }
    }
}


void Foam::fsi::wallOperator::fluxLess
(
    const scalarField& net,
    const vectorField& v,
    scalarField& Jv
) const
{
    const UList<wallFace>& faces = geometry_.wallFaces();

    Jv = Zero;
    forAll(faces, i)
    {
        const wallFace& w = faces[i];
        const scalar q = w.area*w.place.interpolate(v, w.dir);
        const scalar spread = share_[i]*net[w.place.object];
        if (w.lower >= 0)
        {
            Jv[w.lower] += q - spread;
        }
        if (w.upper >= 0)
        {
            Jv[w.upper] -= q + spread;
        }
    }
}


void Foam::fsi::wallOperator::setCuts(const surfaceSet& surfaces)
{
    cutNodes_.clear();
    cutAreas_.clear();
    cutFaces_.clear();
    const auto add = [&](const label nodei, const wallFace& w, const scalar s)
    {
        vector area(Zero);
        area[w.dir] = (w.lower >= 0 ? s : -s)*w.area;
        cutNodes_.append(nodei);
        cutAreas_.append(area);
        cutFaces_.append(w.face);
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
    const UList<wallFace>& faces = geometry_.wallFaces();
    nNodes_ = surfaces.points().size();
    pointObject_ = surfaces.pointObject();
    nObjects_ = surfaces.size();
    meanPressure_.setSize(nObjects_);

    // Wall area of each object, both sides of a face counted
    scalarField area(nObjects_, Zero);
    forAll(faces, i)
    {
        const wallFace& w = faces[i];
        area[w.place.object] +=
            w.area*(label(w.lower >= 0) + label(w.upper >= 0));
    }
    sumOverRanks(area);

    share_.setSize(faces.size());
    forAll(faces, i)
    {
        share_[i] = faces[i].area/max(area[faces[i].place.object], VSMALL);
    }

    setCuts(surfaces);
    transposeSums
    (
        scalarField(geometry_.grid().mesh().nCells(), 1),
        uniformForce_
    );
    vectorField cut(nNodes_, Zero);
    forAll(cutNodes_, i)
    {
        cut[cutNodes_[i]] -= cutAreas_[i];
    }
    sumOverRanks(cut);
    uniformForce_ += cut;
}


void Foam::fsi::wallOperator::outsideForce
(
    const volScalarField& p,
    vectorField& force
) const
{
    // The mean pressure of each object, and with it J^T p
    transposeSums(p.primitiveField(), force);
    force = Zero;

    const polyBoundaryMesh& boundary = p.mesh().boundaryMesh();
    forAll(cutNodes_, i)
    {
        const label patchi = boundary.whichPatch(cutFaces_[i]);
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        const scalar outside =
            pp.fixesValue()
          ? pp[cutFaces_[i] - boundary[patchi].start()]
          : meanPressure_[pointObject_[cutNodes_[i]]];
        force[cutNodes_[i]] -= outside*cutAreas_[i];
    }
    sumOverRanks(force);
}


void Foam::fsi::wallOperator::flux
(
    const vectorField& v,
    scalarField& Jv
) const
{
    // Net flux 1.J v of each object: no exchange, the nodes are on all ranks
    scalarField& net = meanPressure_;
    net = 0;
    forAll(uniformForce_, nodei)
    {
        net[pointObject_[nodei]] += uniformForce_[nodei] & v[nodei];
    }
    fluxLess(net, v, Jv);
}


void Foam::fsi::wallOperator::grossFlux
(
    const vectorField& v,
    scalarField& Jv
) const
{
    fluxLess(scalarField(nObjects_, Zero), v, Jv);
}


void Foam::fsi::wallOperator::transpose
(
    const scalarField& p,
    vectorField& f
) const
{
    transposeSums(p, f);

    // Less the object's mean pressure times J^T 1
    forAll(f, nodei)
    {
        f[nodei] -= meanPressure_[pointObject_[nodei]]*uniformForce_[nodei];
    }
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
    scalarField closed(fluid.size(), Zero);
    for (const wallFace& w : faces)
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0 && !fluid[celli])
            {
                closed[celli] += w.area;
            }
        }
    }

    f.setSize(nNodes_);
    f = Zero;
    const scalarField& V = geometry_.grid().mesh().V();
    for (const wallFace& w : faces)
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli < 0)
            {
                continue;
            }
            w.place.spread(f, w.dir, 0.5*h*w.area*g[celli][w.dir]);
            if (!fluid[celli])
            {
                w.place.spread(f, -w.area/closed[celli]*V[celli]*g[celli]);
            }
        }
    }
    sumOverRanks(f);
}


// ************************************************************************* //
