// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallOperator.H"
#include "fetchAhead.H"
#include "partialForces.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::wallOperator::wallOperator
(
    const interfaceGeometry& geometry,
    const objectRanks& ranks
)
:
    geometry_(geometry),
    ranks_(ranks),
    nNodes_(0),
    nObjects_(0),
    films_(geometry),
    filmFluxes_(geometry)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallOperator::update(const surfaceSet& surfaces)
{
    nNodes_ = surfaces.points().size();
    pointObject_ = surfaces.pointObject();
    pointStart_ = surfaces.pointStart();
    nObjects_ = surfaces.size();
    meanPressure_.setSize(nObjects_);

    atWalls_.update(geometry_);
    perArea_.setSize(nObjects_);
    perArea_ = Zero;
    entries_.update(geometry_, atWalls_, perArea_);
    ranks_.collect({objectRanks::values::ofObjects(perArea_)});
    perArea_ = 1/max(perArea_, VSMALL);
    ranks_.spread({objectRanks::values::ofObjects(perArea_)});
    films_.update();
    cuts_.update(geometry_, surfaces);
    transposeSums(scalarField(atWalls_.size(), 1), uniformForce_, false);
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
    cuts_.addPressure(p, cut.mine(), load.mine());
    uniformForce_ += cut.collectWalls(ranks_);
    force = load.collectWalls(ranks_);
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
    cuts_.addGivenFlux(p, U, isFree, v, pointObject_, givenFlux_);
    ranks_.collect({objectRanks::values::ofObjects(givenFlux_)});
    ranks_.spread({objectRanks::values::ofObjects(givenFlux_)});
}


Foam::scalar Foam::fsi::wallOperator::givenFlux() const
{
    scalar flux = 0;
    for (label objecti = 0; objecti < ranks_.nOwned(nObjects_); ++objecti)
    {
        flux += givenFlux_[objecti];
    }
    return ranks_.sum(flux);
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
    scalarField closed(atWalls_.size(), Zero);
    for (const wallFace& w : faces)
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0 && !fluid[celli])
            {
                closed[place(celli)] += w.area;
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
                const scalar share = w.area/closed[place(celli)];
                const vector rest(films_.rest(celli, g[celli]));
                w.place.spread(mine, -share*V[celli]*rest);
            }
        }
    }
    films_.addForce(g, mine);
    f.transfer(part.collectWalls(ranks_));
}


// ************************************************************************* //
