// SPDX-License-Identifier: GPL-3.0-or-later

#include "motionCheck.H"
#include "emptyPolyPatch.H"
#include "openfoamVersion.H"
#include "polyBoundaryMesh.H"
#include "surfacePredicates.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::motionCheck::nInverted
(
    const bodyGroup& group,
    const label copyi
)
{
    const shapeTemplate& shape = group.shape();
    const auto corner = [&](const label nodei)
    {
        return vector
        (
            group.positions()(nodei, 3*copyi),
            group.positions()(nodei, 3*copyi + 1),
            group.positions()(nodei, 3*copyi + 2)
        );
    };
    scalarField volumes(shape.nNodes(), Zero);
    boolList used(shape.nNodes(), false);
    for (const bodyElement& element : shape.elements())
    {
        const vector a(corner(element[0]));
        const scalar volume =
            ((corner(element[1]) - a)^(corner(element[2]) - a))
          & (corner(element[3]) - a);
        for (const label nodei : element)
        {
            volumes[nodei] += volume;
            used[nodei] = true;
        }
    }
    label number = 0;
    forAll(volumes, nodei)
    {
        // A volume that is no number is none
        number += used[nodei] && !(volumes[nodei] > 0);
    }
    return number;
}


std::string Foam::fsi::motionCheck::namesOf(const labelPair& pair) const
{
    std::string names;
    for (const label objecti : {pair.first(), pair.second()})
    {
        names +=
            (names.empty() ? "" : " and ")
          + std::to_string(objects_.objectId(objecti)) + " of shape "
          + objects_.shape(objects_.objectGroup(objecti)).name();
    }
    return names;
}


void Foam::fsi::motionCheck::checkSpeeds
(
    const vector& box,
    const scalar spacing
) const
{
    const surfaceSet& surfaces = objects_.surfaces();
    scalar shortest = min(box.x(), box.y());
    if (objects_.nDims() == 3)
    {
        shortest = min(shortest, box.z());
    }
    forAll(surfaces.velocities(), nodei)
    {
        const scalar way =
            cmptMax(cmptMag(surfaces.velocities()[nodei]))
           *time_.deltaTValue();
        if (!(way <= 0.5*shortest))
        {
            const label objecti = surfaces.pointObject()[nodei];
            FatalErrorInFunction
                << "Object " << objects_.objectId(objecti)
                << " moves " << way/spacing
                << " cells in one step, more than half of the domain, at time "
                << nameOf(time_) << nl
                << "The run has lost its stability: take a smaller deltaT or "
                << "adjustTimeStep with maxCo; give very soft bodies a "
                << "viscosity (material), and with coupling weak take heavier "
                << "or stiffer objects (doc/theory.md, section 5.3); in a "
                << "stock solver a larger deltaT or stiffer objects"
                << exit(FatalError);
        }
    }
}


void Foam::fsi::motionCheck::checkPrescribed(const vector& period) const
{
    const surfaceSet& surfaces = objects_.surfaces();
    DynamicList<label> prescribed;
    bool moves = false;
    for (label objecti = 0; objecti < objects_.nHeld(); ++objecti)
    {
        if (!objects_.movesFreely(objecti))
        {
            prescribed.append(objecti);
            const label nodei = surfaces.pointStart()[objecti];
            moves = moves || mag(surfaces.velocities()[nodei]) > 0;
        }
    }
    if (!moves || prescribed.size() < 2)
    {
        return;
    }
    const List<labelPair> pairs
    (
        surfacePredicates::overlapping(surfaces, prescribed, period)
    );
    if (pairs.size())
    {
        FatalErrorInFunction
            << "Objects " << namesOf(pairs[0]).c_str()
            << ", both with a prescribed motion, overlap at time "
            << nameOf(time_) << ": nothing can part them. Let their motions"
            << " (entry 'motion' of the shapes) keep them apart"
            << exit(FatalError);
    }
}


void Foam::fsi::motionCheck::checkElements() const
{
    if (objects_.nDims() == 2)
    {
        return;
    }
    for (label objecti = 0; objecti < objects_.size(); ++objecti)
    {
        const bodyGroup& group =
            objects_.groups()[objects_.objectGroup(objecti)];
        const label number = nInverted(group, objects_.objectCopy(objecti));
        if (number > 0)
        {
            const word& name = group.shape().name();
            FatalErrorInFunction
                << "The tetrahedra at " << number << " nodes of object "
                << objects_.objectId(objecti) << " are inverted at time "
                << nameOf(time_) << ": the body, of shape "
                << time_.path()/caseConstant(time_)/bodyGroups::folder/name
                << ", has turned inside out there" << nl
                << "Take a smaller deltaT or adjustTimeStep with maxCo, a "
                << "larger E or a viscosity (material), or a finer mesh; the "
                << "state of the last written time is in uniform/"
                << bodyGroups::folder/name
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::motionCheck::check
(
    const vector& box,
    const scalar spacing,
    const vector& period
) const
{
    checkSpeeds(box, spacing);
    checkElements();
    checkPrescribed(period);
}


void Foam::fsi::motionCheck::checkOverlaps
(
    const vector& period,
    const bool membranes
) const
{
    const surfaceSet& surfaces = objects_.surfaces();
    const auto counts = [&](const label a, const label b)
    {
        return
            (objects_.movesFreely(a) || objects_.movesFreely(b))
         && !(membranes && surfaces.hasWalls(a) && surfaces.hasWalls(b));
    };
    bool wanted = !membranes;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        wanted = wanted || !surfaces.hasWalls(objecti);
    }
    DynamicList<label> sound;
    for (label objecti = 0; wanted && objecti < objects_.nHeld(); ++objecti)
    {
        if (!surfacePredicates::cutsItself(surfaces, objecti))
        {
            sound.append(objecti);
        }
    }
    for
    (
        const labelPair& pair
      : surfacePredicates::overlapping(surfaces, sound, period)
    )
    {
        if (counts(pair.first(), pair.second()))
        {
            FatalErrorInFunction
                << "Objects " << namesOf(pair).c_str()
                << " overlap at the start, time " << nameOf(time_)
                << ": no force could part them. checkObjects lists all; seed"
                << " them anew, or start from another time"
                << exit(FatalError);
        }
    }
}


void Foam::fsi::motionCheck::checkWeight
(
    const polyBoundaryMesh& patches,
    const vector& period,
    const vector& gravity,
    const scalar density
) const
{
    for (const polyPatch& patch : patches)
    {
        const bool slips =
            isA<symmetryPolyPatch>(patch) || isA<symmetryPlanePolyPatch>(patch);
        if (!patch.coupled() && !isA<emptyPolyPatch>(patch) && !slips)
        {
            return;
        }
    }
    scalar weight = 0, all = 0;
    forAll(objects_.groups(), groupi)
    {
        const bodyGroup& group = objects_.groups()[groupi];
        const label n = objects_.nCopies(groupi);
        if (n > 0 && !group.movesFreely())
        {
            return;
        }
        const shapeTemplate& shape = group.shape();
        const scalar ofShape =
            n*shape.mass()*(1 - density/shape.density());
        weight += ofShape;
        all += mag(ofShape);
    }
    const scalar along = mag(cmptMultiply(gravity, period));
    if (mag(weight)*along > 1e-9*all*along)
    {
        WarningInFunction
            << "Nothing holds fluid and objects in this periodic box: gravity"
            << " will move them ever faster." << nl
            << "    A vessel of which this is a part has no mean flow:"
            << " drivingForce { type meanVelocity; velocity (0 0 0); }"
            << " (fsiProperties)" << nl << endl;
    }
}


// ************************************************************************* //
