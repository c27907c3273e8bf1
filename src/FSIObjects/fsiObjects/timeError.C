// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeError.H"
#include "errorOf.H"
#include "backwardStep.H"
#include "openfoamMesh.H"
#include "openfoamVersion.H"
#include "stateFile.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::timeError::timeError(const fvMesh& mesh)
:
    rate_
    (
        IOobject
        (
            "velocityRate",
            nameOf(mesh.time()),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedVector(dimAcceleration, Zero)
    ),
    nKnown_(0),
    before_(0),
    scale_(0),
    ofTime_(0),
    ofSplitting_(0),
    mean_(0),
    nSteps_(0),
    nAbove_(0),
    nRunning_(0)
{
    if (ddtSchemeOf(mesh, "ddt(U)") == "backward")
    {
        curvature_.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "velocityCurvature",
                    nameOf(mesh.time()),
                    mesh,
                    IOobject::READ_IF_PRESENT,
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensionedVector(dimAcceleration/dimTime, Zero)
            )
        );
    }
    const dictionary state(readState(mesh.time(), "fsiTimeError"));
    if (!state.empty())
    {
        scale_ = readEntry<scalar>(state, "scale");
        ofTime_ = readEntry<scalar>(state, "ofTime");
        ofSplitting_ = readEntry<scalar>(state, "ofSplitting");
        state.readIfPresent("known", nKnown_);
        state.readIfPresent("before", before_);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::fsi::timeError::sums
(
    const volVectorField& U,
    const boolList& fluid
)
{
    const scalar deltaT = U.time().deltaTValue();
    const scalar deltaT0 = U.time().deltaT0Value();
    const vectorField& last = U.oldTime().primitiveField();
    scalarList result(3, Zero);
    forAll(U, celli)
    {
        const vector rate((U[celli] - last[celli])/deltaT);
        vector change(rate - rate_[celli]);
        rate_[celli] = rate;
        if (curvature_.valid())
        {
            vector& curvature = curvature_()[celli];
            const vector now(2/(deltaT + deltaT0)*change);
            change = nKnown_ < 2 ? change : now - curvature;
            curvature = now;
        }
        if (fluid[celli])
        {
            result[0] += magSqr(change);
            result[1] += magSqr(U[celli]);
            result[2] += 1;
        }
    }
    sumOverRanks(result);
    return result;
}


Foam::scalar Foam::fsi::timeError::factor() const
{
    const scalar dt = rate_.time().deltaTValue();
    const scalar dt0 = rate_.time().deltaT0Value();
    if (!curvature_.valid() || nKnown_ < 2)
    {
        return sqr(dt)/(dt + dt0);
    }
    const scalar tau = backwardStep{dt/dt0}.length(dt);
    return 0.5*tau*dt*(dt + dt0)/(dt + dt0 + before_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::timeError::measure
(
    const volVectorField& U,
    const boolList& fluid,
    const scalar ofSplitting,
    const scalar restSpeed
)
{
    const scalarList ofCells(sums(U, fluid));
    const scalar nCells = max(ofCells[2], 1.0);
    const bool first = scale_ == 0;
    scale_ = max(0.99*scale_, sqrt(ofCells[1]/nCells));
    ofTime_ =
        first
      ? 0
      : factor()*sqrt(ofCells[0]/nCells)/max(scale_, restSpeed);
    ofSplitting_ = ofSplitting;
    nKnown_ = min(nKnown_ + 1, 2);
    before_ = rate_.time().deltaT0Value();

    ++nSteps_;
    mean_ += (value() - mean_)/min(nSteps_, meanSteps);
    const bool above = value() > warnAbove;
    nAbove_ += above;
    nRunning_ = above ? nRunning_ + 1 : 0;
}


void Foam::fsi::timeError::report(Ostream& os) const
{
    if (nAbove_ > 0)
    {
        os  << "Time error above " << scalar(warnAbove) << " in " << nAbove_
            << " of " << nSteps_ << " steps, mean of the last ones " << mean_
            << nl << endl;
    }
}


void Foam::fsi::timeError::write() const
{
    const Time& time = rate_.time();
    writeFile
    (
        time, nameOf(time), "uniform", "fsiTimeError", IOstream::ASCII,
        [&](Ostream& os)
        {
            putEntry(os, "scale", scale_);
            putEntry(os, "ofTime", ofTime_);
            putEntry(os, "ofSplitting", ofSplitting_);
            if (curvature_.valid())
            {
                putEntry(os, "known", nKnown_);
                putEntry(os, "before", before_);
            }
        }
    );
}


// ************************************************************************* //
