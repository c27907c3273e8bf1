// SPDX-License-Identifier: GPL-3.0-or-later

#include "contact.H"
#include "readBetween.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Read the ranges and check the entries
static contactScales readScales
(
    const dictionary& dict,
    const scalar spacing,
    const scalar youngsModulus
)
{
    checkKeys
    (
        dict,
        {"range", "margin", "minimumGap", "roughness", "search", "law"}
    );
    checkSubDicts(dict, {"search", "law"});
    const scalar range = contact::readRange(dict, spacing);
    return {spacing, range, youngsModulus};
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contact::contact
(
    const dictionary& dict,
    const direction nDims,
    const scalar spacing,
    const scalar youngsModulus,
    const periodicImages& images
)
:
    scales_(readScales(dict, spacing, youngsModulus)),
    margin_(readScalarBetween(dict, "margin", 1, 0, 20)*spacing),
    minimumGap_
    (
        readScalarBetween(dict, "minimumGap", 0.1, 1e-6, 20)*spacing
    ),
    roughness_(readPositive(dict, "roughness", minimumGap_)),
    images_(images),
    finder_(dict.subOrEmptyDict("search"), images_),
    law_(contactLaw::New(dict.subOrEmptyDict("law"), scales_)),
    defence_(minimumGap_, margin_, 0.5*spacing, nDims, images_),
    ranges_(scales_.range, min(minimumGap_, leastRange*spacing))
{
    if
    (
        roughness_ > minimumGap_
     || (dict.found("roughness") && !law_->rigidTouch())
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'roughness' in dictionary " << dict.name() << " is "
            << roughness_ << " m but must be at most minimumGap, "
            << minimumGap_ << " m, and needs a law by which rigid bodies"
            << " touch: all but 'none' and 'thesis'" << exit(FatalIOError);
    }
    if (images_.cyclic() && (needsMedialAxis() || needsInternalForces()))
    {
        FatalIOErrorInFunction(dict)
            << "Search 'medialAxis' and law 'thesis' in dictionary "
            << dict.name() << " do not see through cyclic patches;"
            << " valid searches and laws are all others"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contact::setStretches
(
    const surfaceSet& surfaces,
    const contactBodies& bodies
)
{
    for (contactPair& pair : found_.pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        if (pair.other == own)
        {
            const scalar rest = bodies.restDistance(surfaces, pair);
            pair.stretch = max(scales_.range/max(rest, VSMALL), 1.0);
        }
    }
}


Foam::fsi::contactProblem Foam::fsi::contact::problem
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const contactPairs& pairs
) const
{
    return
    {
        surfaces, velocities, bodies, pairs, scales_.range, step_, exchange_,
        law_->rigidTouch() ? minimumGap_ : 0, 0.5*scales_.spacing,
        law_->actsOnRigid()
    };
}


void Foam::fsi::contact::find
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis
)
{
    const scalar range = scales_.range + margin_;
    scalarField reaches;
    if (!finder_.needsMedialAxis() && law_->startsAtRest())
    {
        reaches = ranges_.reaches(surfaces, margin_);
    }
    limited_ = !reaches.empty();
    do
    {
        finder_.find
        (
            surfaces, bodies, walls, medialAxis, range, found_, reaches
        );
    }
    while (ranges_.widen(surfaces, found_.pairs, margin_, reaches));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::contact::readRange
(
    const dictionary& dict,
    const scalar spacing
)
{
    const scalar cells = readPositive(dict, "range", 3);
    if (cells < 0.01 || cells > 20)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'range' in dictionary " << dict.name() << " is " << cells
            << "; it is a number of mesh cells, 0.01 to 20. Without contact:"
            << " law { type none; }" << exit(FatalIOError);
    }
    return cells*spacing;
}


const Foam::fsi::contactStatistics& Foam::fsi::contact::measure
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis
)
{
    if (!searched(surfaces))
    {
        find(surfaces, bodies, walls, medialAxis);
        setStretches(surfaces, bodies);
        searched_ = surfaces.points();
    }
    if (law_->startsAtRest())
    {
        ranges_.update(surfaces, found_.pairs, exchange_);
    }
    contactProblem all
    (
        problem(surfaces, surfaces.velocities(), bodies, found_)
    );
    counts_.count(all, limited_, statistics_);
    statistics_.potentialEnergy = law_->potentialEnergy
    (
        exchange_
      ? problem
        (
            surfaces,
            surfaces.velocities(),
            bodies,
            counts_.ownPairs(all)
        )
      : all
    );
    return statistics_;
}


const Foam::fsi::contactStatistics& Foam::fsi::contact::calculate
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis,
    const contactStep& step,
    vectorField& force
)
{
    step_ = step;
    step_.rebound *= law_->restitution();
    step_.film.roughness = roughness_;
    measure(surfaces, bodies, walls, medialAxis);

    force.setSize(surfaces.points().size());
    force = Zero;
    const contactPairs& acting = ranges_.acting(surfaces, found_, margin_);
    contactProblem all(problem(surfaces, velocities, bodies, acting));
    all.walls = &walls;
    law_->addForces(all, force, statistics_);
    step_.start = nullptr;
    return statistics_;
}


Foam::label Foam::fsi::contact::limit
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const scalar dt,
    vectorField& force
)
{
    const bool known = !needsMedialAxis() && searched(surfaces);
    return defence_.limit
    (
        surfaces,
        velocities,
        bodies,
        walls,
        dt,
        known ? &found_ : nullptr,
        force,
        exchange_
    );
}


// ************************************************************************* //
