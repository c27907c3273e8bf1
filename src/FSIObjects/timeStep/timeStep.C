// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeStep.H"
#include "stateFile.H"
#include "surfaceFields.H"
#include "openfoamVersion.H"
#include "fsiStep.H"
#include "membraneStep.H"
#include "dictionaryCheck.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Largest sum of |phi|/(2 V) over the faces of a cell of all ranks [1/s]
static scalar largestRate(const surfaceScalarField& phi)
{
    const fvMesh& mesh = phi.mesh();
    scalarField sums(mesh.nCells(), Zero);
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        sums[own[facei]] += mag(phi[facei]);
        sums[nei[facei]] += mag(phi[facei]);
    }
    for (const fvsPatchScalarField& pphi : phi.boundaryField())
    {
        const labelUList& cells = pphi.patch().faceCells();
        forAll(pphi, i)
        {
            sums[cells[i]] += mag(pphi[i]);
        }
    }
    const scalarField& V = mesh.V();
    scalar largest = 0;
    forAll(sums, celli)
    {
        largest = max(largest, sums[celli]/V[celli]);
    }
    return 0.5*overRanks(largest, maxOp<scalar>());
}


//- nu times the sum of 1/h^2 over the solved directions [1/s]
static scalar diffusionRate(const fsiObjects& objects)
{
    const cartesianMesh& grid = objects.grid();
    const fluidProperties& fluid = objects.fluid();
    return
        max(fluid.viscosity, fluid.largestViscosity)
       *grid.nDims()/sqr(grid.spacing());
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::timeStep::timeStep(const Time& time)
:
    time_(time),
    level_(-1),
    warned_(false),
    warnedOfError_(false),
    nSteps_(0)
{
    read();
    const dictionary state(readState(time_, "fsiTimeStep"));
    if (!state.empty())
    {
        checkKeys(state, {"FoamFile", "step"});
        level_ = levelOf(readPositive(state, "step"), maxDeltaT_);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::timeStep::read()
{
    const dictionary& controls = time_.controlDict();
    const scalar maxDeltaT = readPositive
    (
        controls,
        "maxDeltaT",
        readPositive(controls, "deltaT")
    );
    if (level_ >= 0 && maxDeltaT != maxDeltaT_)
    {
        level_ = levelOf(step(level_), maxDeltaT);
    }
    maxDeltaT_ = maxDeltaT;
    adjust_ = controls.lookupOrDefault<Switch>("adjustTimeStep", false);
    maxCo_ = readPositive(controls, "maxCo", 0.5);
    maxDiffusion_ = readNonNegative(controls, "maxDiffusion", 0);
    maxTimeError_ = readNonNegative(controls, "maxTimeError", 0);
    floor_.read(controls);
}


Foam::label Foam::fsi::timeStep::levelOf
(
    const scalar limit,
    const scalar maxDeltaT
)
{
    return
        limit >= maxDeltaT
      ? 0
      : label(ceil(4*log(maxDeltaT/limit)/log(2.0) - 1e-9));
}


void Foam::fsi::timeStep::warn
(
    const scalar courantNo,
    const fsiStep& current
)
{
    if (!adjust_ && !warned_ && courantNo > 2)
    {
        warned_ = true;
        current.objects().log().warned("Courant number above 2");
        WarningInFunction
            << "At a Courant number above 2 the relaxation of U may diverge."
            << nl
            << "    Take a smaller deltaT, or adjustTimeStep yes with maxCo"
            << nl << endl;
    }
    const bool limited = adjust_ && maxTimeError_ > 0;
    if (!limited && !warnedOfError_ && current.error().tooLarge())
    {
        warnedOfError_ = true;
        current.objects().log().warned("time error");
        WarningInFunction
            << "The step is too large: its error is estimated as "
            << 100*current.error().mean() << " % of the velocity in the mean"
            << " over " << label(timeError::meanSteps) << " steps." << nl
            << "    Take a smaller deltaT, adjustTimeStep yes with"
            << " maxTimeError, or more passes (coupling)" << nl << endl;
    }
}


Foam::scalar Foam::fsi::timeStep::byCourant(const scalar courantNo) const
{
    return maxCo_*time_.deltaTValue()/max(courantNo, SMALL);
}


Foam::scalar Foam::fsi::timeStep::limit
(
    const scalar courantNo,
    const fsiStep& current
)
{
    const scalar dt = time_.deltaTValue();
    scalar limit = GREAT;
    const auto atMost = [&](const scalar length, const char* name)
    {
        if (length < limit)
        {
            limit = length;
            holder_ = name;
        }
    };
    atMost(byCourant(courantNo), "maxCo");
    if (maxDiffusion_ > 0)
    {
        atMost
        (
            maxDiffusion_/diffusionRate(current.objects()), "maxDiffusion"
        );
    }
    // OpenFOAM stretches steps by up to half
    atMost(longestMembraneStep(current.objects())/1.5, "membranes");
    const scalar error = current.error().value();
    if (maxTimeError_ > 0 && error > 0)
    {
        const scalar part = maxTimeError_/error;
        const bool first = current.error().order() == 1;
        atMost(dt*max(first ? sqrt(part) : cbrt(part), 0.5), "maxTimeError");
    }
    return limit;
}


bool Foam::fsi::timeStep::grows(const scalar limit) const
{
    return
        level_ > levelOf(limit, maxDeltaT_)
     && step(level_ - 1) <= 0.9*limit;
}


Foam::scalar Foam::fsi::timeStep::step(const label level) const
{
    return maxDeltaT_*pow(2.0, -0.25*level);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::timeStep::choose(const scalar limit)
{
    const label lowest = levelOf(limit, maxDeltaT_);
    if (level_ < 0)
    {
        // The Courant number says nothing of a flow that starts from rest
        const bool first = time_.timeIndex() == 0;
        level_ =
            first
          ? max(lowest, levelOf(time_.deltaTValue(), maxDeltaT_))
          : lowest;
    }
    else if (lowest > level_)
    {
        level_ = lowest;
    }
    else if (grows(limit))
    {
        --level_;
    }
    return step(level_);
}


Foam::scalar Foam::fsi::timeStep::next
(
    const surfaceScalarField& phi,
    const fsiStep& current
)
{
    read();
    const scalar dt = time_.deltaTValue();
    const scalar fluid = dt*largestRate(phi);
    const scalar solid = current.objects().courantNo();
    runLog& log = current.objects().log();
    log.start(fluid, solid);

    warn(max(fluid, solid), current);
    if (!adjust_)
    {
        return dt;
    }
    const scalar longest = limit(max(fluid, solid), current);
    const scalar chosen = choose(longest);
    log.heldBy
    (
        level_ == 0 ? "maxDeltaT"
      : grows(longest) ? "slow growth"
      : holder_
    );
    checkCollapse(chosen, fluid, solid, current);
    return chosen;
}


void Foam::fsi::timeStep::write() const
{
    if (!time_.writeTime() || level_ < 0)
    {
        return;
    }
    writeFile
    (
        time_, nameOf(time_), "uniform", "fsiTimeStep", IOstream::ASCII,
        [&](Ostream& os) { putEntry(os, "step", step(level_)); }
    );
}


// ************************************************************************* //
