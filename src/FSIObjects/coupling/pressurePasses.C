// SPDX-License-Identifier: GPL-3.0-or-later

#include "pressurePasses.H"
#include "activeMean.H"
#include "dictionaryCheck.H"
#include "runLog.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::pressurePasses::pressurePasses(const dictionary& dict)
:
    most_(readAtLeast(dict, "passes", 4, 1)),
    tolerance_(readPositive(dict, "passTolerance", 0.002)),
    done_(0),
    error_(0),
    acceleration_(most_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::pressurePasses::begin()
{
    done_ = 0;
    error_ = 0;
    acceleration_.clear();
}


void Foam::fsi::pressurePasses::measure(const FixedList<scalar, 2>& ofRank)
{
    scalarList squares(ofRank);
    sumOverRanks(squares);
    error_ = sqrt(squares[0]/max(squares[1], VSMALL));
    ++done_;
}


Foam::scalarField Foam::fsi::pressurePasses::next
(
    const scalarField& start,
    const scalarField& found,
    const bool free,
    const boolList& active
)
{
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
        Info<< "Passes: " << done_ << ", splitting error: " << error_ << endl;
    }
    if (done_ > 1)
    {
        log.count("passes", done_);
    }
}


// ************************************************************************* //
