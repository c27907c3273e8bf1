// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeStep.H"
#include "fsiStep.H"
#include "OStringStream.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Warn of a run that will not end in a lifetime
static void warnOfLength
(
    const Time& time,
    const scalar dt,
    const scalar maxDiffusion
)
{
    const scalar left = (time.endTime().value() - time.value())/dt;
    if (left > 1e7)
    {
        WarningInFunction
            << "With steps of " << dt << " s there are " << left
            << " to endTime." << nl << "    Entry "
            << (maxDiffusion > 0 ? "maxDiffusion, " : "")
            << "maxCo, maxTimeError or maxDeltaT of controlDict limits them"
            << nl << endl;
    }
}


//- The fastest object and its speed
static string fastest(const population& bodies)
{
    const surfaceSet& surfaces = bodies.surfaces();
    if (surfaces.velocities().empty())
    {
        return "";
    }
    const label nodei = findMax(mag(surfaces.velocities())());
    OStringStream os;
    os  << ": object "
        << bodies.objectId(surfaces.pointObject()[nodei])
        << " moves at " << mag(surfaces.velocities()[nodei]) << " m/s";
    return os.str();
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::timeStep::checkCollapse
(
    const scalar dt,
    const scalar fluid,
    const scalar solid,
    const fsiStep& current
)
{
    if (nSteps_ == 0)
    {
        warnOfLength(time_, dt, maxDiffusion_);
    }
    // The first steps are as long as the flow is at rest
    if (++nSteps_ > 10)
    {
        floor_.take(dt);
    }
    if (dt >= floor_.value())
    {
        return;
    }
    FatalErrorInFunction
        << "At time " << nameOf(time_) << " the time step falls to " << dt
        << " s, below " << floor_.value() << " s";
    const scalar courantNo = max(fluid, solid);
    if (limit(courantNo, current) < byCourant(courantNo))
    {
        FatalError
            << nl << "This is no matter of speed: maxTimeError or maxDiffusion"
            << " of the controlDict asks for it. Take a larger one, or set"
            << " minDeltaT" << exit(FatalError);
    }
    if (fluid > solid)
    {
        FatalError
            << ": the fluid moves at " << current.objects().speedOf(fluid)
            << " m/s";
    }
    else
    {
        FatalError<< fastest(current.objects().bodies()).c_str();
    }
    FatalError
        << nl << "Such a speed is absurd, the run has lost its stability: take"
        << " a smaller maxCo, give very soft bodies a viscosity (material) or a"
        << " larger E, and let no inlet be blocked. If the speed is meant, set"
        << " minDeltaT" << exit(FatalError);
}


// ************************************************************************* //
