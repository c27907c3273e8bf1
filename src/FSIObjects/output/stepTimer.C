// SPDX-License-Identifier: GPL-3.0-or-later

#include "stepTimer.H"
#include "IOmanip.H"
#include "error.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

const Foam::Enum<Foam::fsi::stepTimer::part>
Foam::fsi::stepTimer::partNames
({
    { part::fluid, "fluid" },
    { part::pressure, "pressure" },
    { part::levelSet, "levelSet" },
    { part::solids, "solids" },
    { part::contact, "contact" },
    { part::coupling, "coupling" }
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Seconds between two times of a clock
template<class TimePoint>
static scalar secondsBetween(const TimePoint& from, const TimePoint& to)
{
    return std::chrono::duration<double>(to - from).count();
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::stepTimer::section::section(stepTimer& timer, const part p)
:
    timer_(timer)
{
    timer_.start(p);
}


Foam::fsi::stepTimer::section::~section()
{
    timer_.stop();
}


Foam::fsi::stepTimer::stepTimer()
:
    lapStart_(clock::now()),
    stepStart_(lapStart_),
    current_(0.0),
    lastStep_(0.0),
    lastStepSeconds_(0),
    total_(0.0),
    totalSeconds_(0),
    nSteps_(0),
    rate_(0),
    remaining_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::stepTimer::lap()
{
    const clock::time_point now = clock::now();
    if (running_.size())
    {
        current_[label(running_.last())] += secondsBetween(lapStart_, now);
    }
    lapStart_ = now;
}


void Foam::fsi::stepTimer::start(const part p)
{
    lap();
    running_.append(p);
}


void Foam::fsi::stepTimer::stop()
{
    lap();
    running_.remove();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::stepTimer::endStep
(
    const scalar time,
    const scalar deltaT,
    const scalar endTime
)
{
    if (running_.size())
    {
        FatalErrorInFunction
            << "The part " << partNames[running_.last()]
            << " is still running at the end of the step"
            << exit(FatalError);
    }

    const clock::time_point now = clock::now();
    lastStepSeconds_ = secondsBetween(stepStart_, now);
    stepStart_ = now;

    lastStep_ = current_;
    current_ = 0.0;
    for (label i = 0; i < nParts; ++i)
    {
        total_[i] += lastStep_[i];
    }
    totalSeconds_ += lastStepSeconds_;
    ++nSteps_;

    // The first steps are averaged, later ones are forgotten slowly
    const scalar weight = max(1.0/nSteps_, 0.02);
    rate_ += weight*(deltaT/max(lastStepSeconds_, SMALL) - rate_);
    remaining_ = max(endTime - time, 0.0)/max(rate_, VSMALL);
}


void Foam::fsi::stepTimer::report(Ostream& os) const
{
    const auto line = [&](const word& name, const scalar seconds)
    {
        os  << "    " << setw(10) << name
            << setw(14) << seconds
            << setw(14) << 100*seconds/max(totalSeconds_, VSMALL)
            << setw(14) << seconds/max(nSteps_, 1) << nl;
    };

    scalar other = totalSeconds_;
    const label precision = os.precision(6);
    os  << nl << "Wall-clock time of " << nSteps_ << " steps" << nl
        << "    " << setw(10) << "part" << setw(14) << "seconds"
        << setw(14) << "percent" << setw(14) << "per step" << nl;
    for (label i = 0; i < nParts; ++i)
    {
        line(partNames[part(i)], total_[i]);
        other -= total_[i];
    }
    line("other", other);
    line("all", totalSeconds_);
    os  << endl;
    os.precision(precision);
}


Foam::string Foam::fsi::stepTimer::clockString(const scalar seconds)
{
    // Longer than ten years is not an estimate
    if (!(seconds < 3e8))
    {
        return "unknown";
    }
    const long s = std::lround(seconds);
    char text[32];
    std::snprintf
    (
        text, sizeof(text), "%ld:%02ld:%02ld", s/3600, (s/60) % 60, s % 60
    );
    return text;
}


// ************************************************************************* //
