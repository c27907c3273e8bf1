// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiStep.H"
#include "heldVolumes.H"
#include "needAllObjects.H"
#include "objectResponse.H"
#include "projectVersion.H"
#include "restartFiles.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(fsiStep, 0);
    defineRunTimeSelectionTable(fsiStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fsiStep::fsiStep(fsiObjects& objects)
:
    objects_(objects),
    error_(objects.grid().mesh()),
    velocity_(objects.bodies().layout()),
    hydrodynamicForce_(objects.bodies().layout().nSurface(), Zero),
    output_(objects)
{
    wordList volumes(objects.properties().subOrEmptyDict("scalars").toc());
    for (word& name : volumes)
    {
        name = heldVolumes::nameFor(name);
    }
    restartFiles::check(objects.grid().mesh(), volumes);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::fsiStep> Foam::fsi::fsiStep::New
(
    fsiObjects& objects,
    const flowFields& flow
)
{
    const dictionary& dict = objects.properties().subOrEmptyDict("coupling");
    autoPtr<fsiStep> step
    (
        constructorOf
        (
            *dictionaryConstructorTablePtr_,
            objects.properties(),
            "coupling",
            couplingType(objects.properties())
        )(objects, flow, dict)
    );
    step->announce();
    return step;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::fsi::fsiStep::feed()
{
    checkCrossing();
    const bool changed = objects_.feed();
    if (changed)
    {
        velocity_.reset();
        hydrodynamicForce_.setSize(objects_.bodies().layout().nSurface());
        hydrodynamicForce_ = Zero;
    }
    return changed;
}


void Foam::fsi::fsiStep::predictAlone
(
    const groupNodal& force,
    const stepLength& step
)
{
    const stepTimer::section solids(objects_.timer(), stepTimer::part::solids);
    const Time& time = objects_.grid().mesh().time();
    predictObjects
    (
        objects_.bodies(),
        time.value() - step.dt,
        step,
        force,
        velocity_.change()
    );
    objects_.constrain(velocity_, step);
    objects_.push(velocity_, step);
    objects_.constrain(velocity_, step);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fsiStep::describe(Ostream& os) const
{
    os  << "coupling " << type();
}


void Foam::fsi::fsiStep::checkParts() const
{
    for (const word& entry : {word("scalars"), word("frame")})
    {
        if (objects_.properties().found(entry) && !carriesScalars())
        {
            FatalIOErrorInFunction(objects_.properties())
                << "Entry '" << entry << "' needs the coupling solidImplicit"
                << " or weak, but entry 'type' of coupling is " << type()
                << exit(FatalIOError);
        }
    }
    for (const bodyGroup& group : objects_.bodies().groups())
    {
        if (!group.hasWalls() && !movesMembranes())
        {
            FatalIOErrorInFunction(objects_.properties())
                << "Entry 'type' of coupling is " << type() << ", but shape "
                << group.shape().name() << " is a membrane inside the fluid,"
                << " which needs the coupling solidImplicit"
                << exit(FatalIOError);
        }
    }
}


void Foam::fsi::fsiStep::announce() const
{
    checkParts();
    const population& bodies = objects_.bodies();
    const label nNodes = label(bodies.ranks().sum(bodies.nNodes()));
    Info<< "FSIObjects " << projectVersion << ": "
        << bodies.nAll() << " objects, "
        << nNodes << " nodes, ";
    describe(Info);
    Info<< ", level set " << objects_.levelSet().type() << nl << endl;
}


// ************************************************************************* //
