// SPDX-License-Identifier: GPL-3.0-or-later

#include "runLog.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "Time.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Three digits of a number; what is not known is infinite
static std::string digits(const scalar value)
{
    if (value >= GREAT)
    {
        return "inf";
    }
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g", double(value));
    return text;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::runLog::runLog(const Time& time, const dictionary& output)
:
    time_(time),
    full_(readChoice(output, "log", "brief", {"brief", "full"}) == "full"),
    courant_(-1),
    maxCourant_(0),
    nSteps_(0),
    smallestStep_(GREAT)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::runLog::add(const stepRecord& record)
{
    const stepRecord before(worst_);
    worst_ = record;
    worst_.deltaT = max(before.deltaT, record.deltaT);
    worst_.smallestGap = min(before.smallestGap, record.smallestGap);
    worst_.maxSpeed = max(before.maxSpeed, record.maxSpeed);
    worst_.areaChange = max(before.areaChange, record.areaChange);
    smallestStep_ = min(smallestStep_, record.deltaT);
    maxCourant_ = max(maxCourant_, courant_);
    ++nSteps_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::runLog::start(const scalar fluid, const scalar objects)
{
    courant_ = max(fluid, objects);
    if (full_)
    {
        Info<< "Courant Number fluid: " << fluid << " objects: " << objects
            << endl;
    }
}


void Foam::fsi::runLog::name() const
{
    if (full_)
    {
        Info<< "deltaT = " << time_.deltaTValue() << nl
            << "Time = " << nameOf(time_) << endl;
    }
}


void Foam::fsi::runLog::count(const word& what, const label n)
{
    if (!allCounts_.found(what))
    {
        names_.append(what);
        Foam::sort(names_);
    }
    counts_(what) += n;
    allCounts_(what) += n;
}


void Foam::fsi::runLog::solved(const solverPerformance& result)
{
    if (full_)
    {
        result.print(Info);
    }
    count(result.fieldName(), result.nIterations());
    if (!result.converged())
    {
        warned(result.fieldName() + " not converged");
    }
}


void Foam::fsi::runLog::warned(const string& what)
{
    ++warnings_(what);
}


void Foam::fsi::runLog::setWarnings(const string& what, const label n)
{
    if (n > 0)
    {
        warnings_.set(what, n);
    }
}


Foam::string Foam::fsi::runLog::line
(
    const stepRecord& record,
    const stepTimer& timer
) const
{
    const scalar start = time_.startTime().value();
    const scalar share =
        (record.time - start)/max(time_.endTime().value() - start, VSMALL);

    // Stock solvers print the time themselves
    string text(courant_ < 0 ? "Objects at " : "Time = ");
    text += nameOf(time_);
    text +=
        " (" + std::to_string(label(100*min(max(share, 0.0), 1.0) + 1e-6))
      + " %, " + stepTimer::clockString(timer.remaining()) + " left)";

    text += " dt " + digits(record.deltaT);
    if (courant_ >= 0)
    {
        text += " Co " + digits(courant_);
    }
    for (const word& name : names_)
    {
        text += " " + name + " " + std::to_string(valueOr(counts_, name, 0));
    }
    return
        text
      + " contacts " + std::to_string(record.contacts)
      + " gap " + digits(record.smallestGap)
      + " speed " + digits(record.maxSpeed)
      + " error " + digits(record.timeError);
}


void Foam::fsi::runLog::finish
(
    const stepRecord& record,
    const stepTimer& timer
)
{
    add(record);
    if (full_)
    {
        record.log(Info, timer);
    }
    else
    {
        Info<< line(record, timer).c_str() << endl;
    }
    counts_.clear();
}


Foam::string Foam::fsi::runLog::warnings() const
{
    string text;
    for (const string& what : warnings_.sortedToc())
    {
        text +=
            (text.empty() ? "" : ", ") + std::to_string(warnings_[what])
          + " x " + what;
    }
    return text.empty() ? string("none") : text;
}


Foam::string Foam::fsi::runLog::heldBy() const
{
    string text;
    for (const auto& each : holders_)
    {
        text +=
            (text.empty() ? ", held by " : ", ") + each.first + " ("
          + std::to_string(each.second) + ")";
    }
    return text;
}


void Foam::fsi::runLog::report(Ostream& os) const
{
    if (nSteps_ == 0)
    {
        return;
    }
    os  << nl << "Summary of " << nSteps_ << " steps to time "
        << nameOf(time_) << nl
        << "    time step         " << digits(smallestStep_).c_str() << " to "
        << digits(worst_.deltaT).c_str() << " s" << heldBy().c_str() << nl
        << "    Courant number    up to " << digits(maxCourant_).c_str() << nl
        << "    in a step        ";
    for (const word& name : names_)
    {
        os  << " " << name << " "
            << digits(scalar(allCounts_[name])/nSteps_).c_str();
    }
    os  << nl
        << "    objects           " << worst_.objects << ", removed "
        << worst_.removed << ", fed " << worst_.fed << nl
        << "    smallest gap      "
        << digits(worst_.smallestGap).c_str()
        << (worst_.smallestGap < GREAT ? " m" : ": none in range") << nl
        << "    largest speed     " << digits(worst_.maxSpeed).c_str()
        << " m/s" << nl
        << "    volumes changed   by up to "
        << digits(100*worst_.areaChange).c_str() << " %" << nl
        << "    warnings          " << warnings().c_str() << endl;
}


// ************************************************************************* //
