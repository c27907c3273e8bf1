// SPDX-License-Identifier: GPL-3.0-or-later

#include "functionMotion.H"
#include "addToRunTimeSelectionTable.H"
#include "openfoamVersion.H"
#include "readFunction.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(functionMotion, 0);
    addToRunTimeSelectionTable(bodyMotion, functionMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static Foam::vector valueOf
(
    const Foam::autoPtr<Foam::Function1<Foam::vector>>& function,
    const Foam::scalar time
)
{
    return function.valid() ? function->value(time) : Foam::vector(Foam::Zero);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::functionMotion::functionMotion(const dictionary& dict)
:
    bodyMotion(dict, {"displacement", "rotation"})
{
    if (dict.found("displacement"))
    {
        displacement_ = readFunction<vector>(dict, "displacement");
    }
    if (dict.found("rotation"))
    {
        rotation_ = readFunction<vector>(dict, "rotation");
    }
    if (!displacement_.valid() && !rotation_.valid())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'displacement' or 'rotation' must be in dictionary "
            << dict.name() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::functionMotion::displacement(const scalar clock) const
{
    return valueOf(displacement_, clock);
}


Foam::vector Foam::fsi::functionMotion::rotation(const scalar clock) const
{
    return valueOf(rotation_, clock);
}



// ************************************************************************* //
