// SPDX-License-Identifier: GPL-3.0-or-later

#include "historyCheck.H"
#include "ListOps.H"
#include "stepHistory.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Index of the largest value, or of a value that is not a number; -1 if there
//  are no values
static label worst(const scalarField& values)
{
    label worsti = -1;
    forAll(values, i)
    {
        if (worsti < 0 || !(values[i] <= values[worsti]))
        {
            worsti = i;
        }
    }
    return worsti;
}


static scalar median(scalarField values)
{
    Foam::sort(values);
    return values[values.size()/2];
}


//- One of the values that are checked: a column, its largest value, a limit
struct checkedValue
{
    const char* fault;

    scalarField values;

    scalar limit;

    //- If the limit is passed, write a line and return 1, else return 0
    label write(const scalarField& times, Ostream& os) const
    {
        const label i = worst(values);
        if (values[i] <= limit)
        {
            return 0;
        }
        os  << "    " << fault << ": " << values[i] << " at t = " << times[i]
            << ", limit " << limit << nl;
        return 1;
    }
};

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::historyCheck::check
(
    const stepHistory& history,
    Ostream& os
) const
{
    for (const string& fault : history.faults())
    {
        os  << fault.c_str() << nl;
    }
    if (history.size() == 0)
    {
        if (maxSpeed > 0 || minStep > 0)
        {
            FatalErrorInFunction
                << "There is no global.csv to check the steps from"
                << exit(FatalError);
        }
        os  << "Steps: none are written" << nl;
        return history.faults().size();
    }

    const scalarField time(history.column("time"));
    const scalarField dt(history.column("deltaT"));
    const scalarField everAdded
    (
        history.column("objects") + history.column("removed")
      - history.column("fed")
    );
    const checkedValue lost
    {
        "Objects are lost", mag(everAdded - everAdded[0]), 0
    };
    const bool planar = nDims == 2;
    const char* const off = planar ? "Areas are off" : "Volumes are off";
    const checkedValue area{off, history.column("areaChange"), areaTolerance};
    const checkedValue shortness
    {
        "Time steps are short, median over step", median(dt)/dt,
        minStep > 0 ? 1/minStep : GREAT
    };

    os  << "Steps: " << history.size() << ", " << max(lost.values)
        << " lost, " << (planar ? "area" : "volume") << " change "
        << max(area.values) << ", smallest step " << min(dt) << ", median "
        << median(dt);
    label nFaults = history.faults().size();
    if (maxSpeed > 0)
    {
        const checkedValue speed
        {
            "Objects are too fast", history.column("maxSpeed"), maxSpeed
        };
        os  << ", largest speed " << max(speed.values) << nl;
        nFaults += speed.write(time, os);
    }
    else
    {
        os  << nl;
    }
    return
        nFaults
      + lost.write(time, os) + area.write(time, os) + shortness.write(time, os);
}


// ************************************************************************* //
