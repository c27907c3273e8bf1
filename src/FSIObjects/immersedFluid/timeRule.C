// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeRule.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::timeRule::timeRule(const fvMesh& mesh)
:
    mesh_(mesh),
    backward_(ddtSchemeOf(mesh, "ddt(U)") == "backward"),
    ratio_(0)
{
    const word scheme(ddtSchemeOf(mesh, "ddt(U)"));
    if (!backward_ && scheme != "Euler")
    {
        FatalIOErrorInFunction(schemesOf(mesh))
            << "Entry 'ddt(U)' or 'default' of ddtSchemes is " << scheme
            << " but must be Euler or backward"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::timeRule::begin
(
    const volVectorField& U,
    const surfaceScalarField& phi
)
{
    ratio_ = 0;
    if (!backward_)
    {
        return;
    }
    if (U.nOldTimes() >= 2 && phi.nOldTimes() >= 2)
    {
        const Time& time = mesh_.time();
        ratio_ = time.deltaTValue()/time.deltaT0Value();
    }

    // From here on both are kept
    U.oldTime().oldTime();
    phi.oldTime().oldTime();
}


Foam::tmp<Foam::vectorField> Foam::fsi::timeRule::start
(
    const volVectorField& U
) const
{
    const vectorField& last = U.oldTime().primitiveField();
    if (ratio_ == 0)
    {
        return last;
    }
    const vectorField& before = U.oldTime().oldTime().primitiveField();
    return last + backwardStep{ratio_}.share()*(last - before);
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::timeRule::start
(
    const surfaceScalarField& f
) const
{
    if (!backward_)
    {
        return f;
    }

    // Kept from here on; of the first step nothing older is known
    const surfaceScalarField& last = f.oldTime();
    const surfaceScalarField& before = last.oldTime();
    return last + backwardStep{ratio_}.share()*(last - before);
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::timeRule::flux
(
    const surfaceScalarField& phi
) const
{
    if (ratio_ == 0)
    {
        return phi;
    }
    return
        (1 + ratio_)*phi.oldTime() - ratio_*phi.oldTime().oldTime();
}


// ************************************************************************* //
