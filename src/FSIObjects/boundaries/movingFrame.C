// SPDX-License-Identifier: GPL-3.0-or-later

#include "movingFrame.H"
#include "dictionaryCheck.H"
#include "domainSides.H"
#include "errorOf.H"
#include "population.H"
#include "readBetween.H"
#include "stateFile.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::movingFrame::read(const dictionary& dict)
{
    checkKeys(dict, {"follow", "direction"});
    const token follow(dict.lookup("follow"));
    if (follow.isLabel() && follow.labelToken() >= 0)
    {
        object_ = follow.labelToken();
    }
    else if (!follow.isWord() || follow.wordToken() != "all")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'follow' in dictionary " << dict.name() << " is "
            << follow << " but must be the id of an object, or all"
            << exit(FatalIOError);
    }
    direction_ = readFinite(dict, "direction");
    if (mag(direction_) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'direction' in dictionary " << dict.name()
            << " must not be zero" << exit(FatalIOError);
    }
    direction_ /= mag(direction_);
    const dictionary state(readState(time_, "fsiFrame"));
    if (!state.empty())
    {
        velocity_ = readEntry<vector>(state, "velocity");
        lastVelocity_ = readEntry<vector>(state, "lastVelocity");
        position_ = readEntry<vector>(state, "position");
        lastPosition_ = readEntry<vector>(state, "lastPosition");
    }
}


Foam::vector Foam::fsi::movingFrame::meanVelocity
(
    const population& objects
) const
{
    scalarField sums(4, Zero);
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        if (object_ < 0 || objects.objectId(objecti) == object_)
        {
            const bodyGroup& group =
                objects.groups()[objects.objectGroup(objecti)];
            const vector v(group.velocity(objects.objectCopy(objecti)));
            for (direction d = 0; d < 3; ++d)
            {
                sums[d] += v[d];
            }
            sums[3] += 1;
        }
    }
    objects.ranks().sum(sums);
    if (sums[3] == 0)
    {
        FatalErrorInFunction
            << "The object that the entry 'frame' of constant/fsiProperties"
            << " follows is not there any more" << exit(FatalError);
    }
    return vector(sums[0], sums[1], sums[2])/sums[3];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::movingFrame::movingFrame
(
    const Time& time,
    const dictionary& fsiProperties
)
:
    time_(time),
    active_(fsiProperties.found("frame")),
    object_(-1),
    direction_(Zero),
    velocity_(Zero),
    lastVelocity_(Zero),
    position_(Zero),
    lastPosition_(Zero),
    acceleration_(Zero)
{
    if (active_)
    {
        read(fsiProperties.subDict("frame"));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::movingFrame::check
(
    const volVectorField& U,
    const population& objects,
    const dictionary& fsiProperties
) const
{
    if (!active_)
    {
        return;
    }
    const wordList types
    ({
        "fixedValue", "zeroGradient", "cyclic", "processor",
        "processorCyclic", "empty", "symmetry", "symmetryPlane", "slip"
    });
    for (const fvPatchVectorField& patch : U.boundaryField())
    {
        const polyPatch& faces = patch.patch().patch();
        const scalarField across(mag(patch.patch().nf() & direction_));
        const bool crosses = across.size() && max(across) > 1e-6;
        if (!isIn(types, patch.type()))
        {
            FatalIOErrorInFunction(fsiProperties)
                << "Entry 'type' of patch " << faces.name() << " in file "
                << pathOf(U) << " is " << patch.type() << ", which does not"
                << " move with the entry 'frame' of " << fsiProperties.name()
                << "; take one of " << flatOutput(types)
                << " (for noSlip: fixedValue with (0 0 0))"
                << exit(FatalIOError);
        }
        if (crosses && !faces.coupled() && !domainSides::isOpen(faces))
        {
            FatalIOErrorInFunction(fsiProperties)
                << "Patch " << faces.name() << " lies across the entry"
                << " 'direction' of 'frame' in " << fsiProperties.name()
                << ": it must be of type patch, where fluid flows in and out,"
                << " or cyclic" << exit(FatalIOError);
        }
    }
    for (const bodyGroup& group : objects.groups())
    {
        if (!group.movesFreely() || !group.shape().held().empty())
        {
            FatalIOErrorInFunction(fsiProperties)
                << "Shape " << group.shape().name() << " has a prescribed"
                << " motion or is held, which the entry 'frame' of "
                << fsiProperties.name() << " does not know"
                << exit(FatalIOError);
        }
    }
}


void Foam::fsi::movingFrame::follow
(
    const population& objects,
    const stepLength& step,
    const backwardStep& rule,
    volVectorField& U
)
{
    if (!active_)
    {
        return;
    }
    const vector gain((meanVelocity(objects) & direction_)*direction_);
    const scalar share = rule.share();
    const vector startVelocity(velocity_ + share*(velocity_ - lastVelocity_));
    const vector start(position_ + share*(position_ - lastPosition_));
    lastVelocity_ = velocity_;
    lastPosition_ = position_;
    velocity_ += gain;
    acceleration_ = (velocity_ - startVelocity)/step.tau;
    position_ = start + step.tau*velocity_;
    for (fvPatchVectorField& patch : U.boundaryFieldRef())
    {
        if (patch.type() == "fixedValue")
        {
            patch == vectorField(patch - gain);
        }
    }
}


void Foam::fsi::movingFrame::write() const
{
    if (!active_)
    {
        return;
    }
    writeFile
    (
        time_, nameOf(time_), "uniform", "fsiFrame", IOstream::ASCII,
        [&](Ostream& os)
        {
            putEntry(os, "velocity", velocity_);
            putEntry(os, "lastVelocity", lastVelocity_);
            putEntry(os, "position", position_);
            putEntry(os, "lastPosition", lastPosition_);
        }
    );
}


// ************************************************************************* //
