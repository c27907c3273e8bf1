// SPDX-License-Identifier: GPL-3.0-or-later

#include "pressurePasses.H"
#include "activeMean.H"
#include "dictionaryCheck.H"
#include "largestSpeed.H"
#include "runLog.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::pressurePasses::worse(const scalar nodes, const scalar fluid)
{
    if (done_ == 1)
    {
        // Its start is the last pressure, not an answer of the objects: where
        // a body is pushed the second pass has up to eight times its e
        firstSpeed_ = nodes;
        leastError_ = GREAT;
        return false;
    }
    if (error_ > 2*leastError_ || nodes > 2*max(fluid, firstSpeed_))
    {
        return true;
    }
    leastError_ = min(leastError_, error_);
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::pressurePasses::pressurePasses
(
    const dictionary& dict,
    const bool one
)
:
    most_(readAtLeast(dict, "passes", one ? 1 : 16, 1)),
    enough_(dict.found("passes") ? most_ : 4),
    tolerance_(readPositive(dict, "passTolerance", 0.002)),
    done_(0),
    error_(0),
    leastError_(0),
    firstSpeed_(0),
    change_(GREAT),
    held_(false),
    refused_(false),
    nRefused_(0),
    acceleration_(most_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::pressurePasses::begin()
{
    done_ = 0;
    error_ = 0;
    refused_ = false;
    nRefused_ = 0;
    acceleration_.clear();
}


void Foam::fsi::pressurePasses::measure
(
    const FixedList<scalar, 2>& ofRank,
    const scalar atRest,
    const nodeLayout::groupNodal& velocity,
    const scalar fluid,
    const bool held
)
{
    scalarList squares({ofRank[0], ofRank[1], scalar(held)});
    sumOverRanks(squares);
    held_ = squares[2] > 0;
    error_ = sqrt(squares[0]/max(squares[1], atRest));
    ++done_;
    const scalar nodes =
        overRanks(largestSpeed(velocity), maxOp<scalar>());
    const bool decide = enough_ < most_;
    if (decide && done_ >= enough_)
    {
        forAll(velocity, groupi)
        {
            velocity_[groupi] -= velocity[groupi];
        }
        change_ =
            overRanks(largestSpeed(velocity_), maxOp<scalar>())
           /max(nodes, VSMALL);
    }
    if (decide && done_ + 1 >= enough_)
    {
        velocity_ = velocity;
    }
    if (refused_)
    {
        // The one before once more: go on from it, without what led astray
        refused_ = false;
        acceleration_.clear();
        return;
    }
    refused_ = worse(nodes, fluid);
    nRefused_ += refused_;
}


Foam::scalarField Foam::fsi::pressurePasses::next
(
    const scalarField& start,
    const scalarField& found,
    const bool free,
    const boolList& active
)
{
    if (refused())
    {
        return acceleration_.lastStart();
    }
    scalarField change(found - start);
    if (free)
    {
        const scalar mean = activeMean(change, active);
        forAll(change, celli)
        {
            change[celli] -= active[celli] ? mean : 0;
        }
    }
    return acceleration_.next(start, change);
}


void Foam::fsi::pressurePasses::report(runLog& log) const
{
    if (log.full())
    {
        Info<< "Passes: " << done_ << ", refused: " << nRefused_
            << ", splitting error: " << error_ << endl;
    }
    if (nRefused_)
    {
        log.warned("passes that made it worse");
    }
    if (most_ > 1)
    {
        log.count("passes", done_);
    }
}


// ************************************************************************* //
