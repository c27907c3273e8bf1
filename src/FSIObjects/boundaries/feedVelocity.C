// SPDX-License-Identifier: GPL-3.0-or-later

#include "feedVelocity.H"
#include "bodyMotion.H"
#include "domainSides.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Begin the message
static Ostream& refused(const dictionary& dict, const vector& velocity)
{
    FatalIOErrorInFunction(dict)
        << "Entry 'velocity' in dictionary " << dict.name() << " is "
        << velocity << " but ";
    return FatalIOError;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::checkFeedVelocity
(
    const dictionary& dict,
    const vector& velocity,
    const label sidei,
    const cartesianMesh& grid,
    const dictionary& motion,
    const scalar start
)
{
    const vector outward(domainSides::outward(sidei));
    if ((velocity & outward) >= 0)
    {
        refused(dict, velocity)
            << "must point into the domain, against " << outward
            << exit(FatalIOError);
    }
    const Time& time = grid.mesh().time();
    const scalar dt = time.deltaTValue();
    const scalar way = mag(velocity)*dt;
    const Switch adjusts
    (
        time.controlDict().lookupOrDefault<Switch>("adjustTimeStep", false)
    );
    if (!adjusts && way > 0.5*grid.bounds().span()[sidei/2])
    {
        refused(dict, velocity)
            << "takes objects " << way << " m far in a step of " << dt
            << " s, more than half of the domain" << exit(FatalIOError);
    }
    const autoPtr<bodyMotion> prescribed(bodyMotion::New(motion));
    if (prescribed.valid())
    {
        const Eigen::Vector3d shift
        (
            prescribed->shift(start, start + dt, grid.mesh().nGeometricD())
        );
        const vector given(shift.x(), shift.y(), shift.z());
        if (mag(given/dt - velocity) > 1e-6*mag(velocity))
        {
            refused(dict, velocity)
                << "the shape has a prescribed motion, whose velocity is "
                << given/dt << " at the start" << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
