// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeError.H"
#include "openfoamVersion.H"
#include "sumOverRanks.H"
#include "writtenDictionary.H"

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
    scale_(0),
    ofTime_(0),
    ofSplitting_(0),
    mean_(0),
    nSteps_(0),
    nAbove_(0),
    nRunning_(0)
{
    const dictionary state(readState(mesh.time(), "fsiTimeError"));
    if (!state.empty())
    {
        scale_ = getEntry<scalar>(state, "scale");
        ofTime_ = getEntry<scalar>(state, "ofTime");
        ofSplitting_ = getEntry<scalar>(state, "ofSplitting");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::timeError::measure
(
    const volVectorField& U,
    const boolList& fluid,
    const scalar ofSplitting
)
{
    const scalar deltaT = U.time().deltaTValue();
    const scalar deltaT0 = U.time().deltaT0Value();
    const vectorField& last = U.oldTime().primitiveField();
    scalarList sums(3, Zero);
    forAll(U, celli)
    {
        const vector rate((U[celli] - last[celli])/deltaT);
        if (fluid[celli])
        {
            sums[0] += magSqr(rate - rate_[celli]);
            sums[1] += magSqr(U[celli]);
            sums[2] += 1;
        }
        rate_[celli] = rate;
    }
    sumOverRanks(sums);
    const bool first = scale_ == 0;
    scale_ = max(0.99*scale_, sqrt(sums[1]/max(sums[2], 1.0)));
    ofTime_ =
        first
      ? 0
      : sqr(deltaT)/(deltaT + deltaT0)*sqrt(sums[0]/max(sums[2], 1.0))
       /max(scale_, VSMALL);
    ofSplitting_ = ofSplitting;

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
        }
    );
}


// ************************************************************************* //
