// SPDX-License-Identifier: GPL-3.0-or-later

#include "packedPlacement.H"
#include "addToRunTimeSelectionTable.H"
#include "packedLattice.H"
#include "readBetween.H"
#include "rotations.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(packedPlacement, 0);
    addToRunTimeSelectionTable(placement, packedPlacement, dictionary);

    //- Random places that are tried before each sweep for objects that the
    //  lattice has no room for, and the sweeps without success after which
    //  the space counts as full
    static const label attempts = 1000, patience = 50;
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::fsi::packedPlacement::bestSites
(
    const packing& space,
    const boundBox& container
) const
{
    const closedSurface object = space.shape(shape()).moved(rotation(), Zero);
    checkFits(object, container);

    pointField best;
    for (const auto type : packedLattice::arrangements(nDims()))
    {
        const packedLattice lattice(object, minimumGap(), type);
        DynamicList<point> free;
        placedObject candidate;
        candidate.shape = shape();
        candidate.rotation = rotation();
        for (const point& site : lattice.sites(container))
        {
            candidate.centre = site;
            if (space.findConflict(candidate, minimumGap()) < 0)
            {
                free.append(site);
            }
        }
        if (free.size() > best.size())
        {
            best = free;
        }
    }
    return best;
}


void Foam::fsi::packedPlacement::thin(pointField& sites, const label number)
{
    // The first ones of a random order, as far as it is needed
    for (label i = 0; i < number; ++i)
    {
        const label j = random().between(i, sites.size() - 1);
        Swap(sites[i], sites[j]);
    }
    sites.resize(number);
}


bool Foam::fsi::packedPlacement::tryMove
(
    packing& space,
    const boundBox& container,
    const label objecti,
    const vector& displacement,
    const tensor& turn
)
{
    placedObject object = space[objecti];
    object.centre += displacement;
    object.rotation = turn & object.rotation;
    if
    (
        !space.inside(object, container)
     || space.findConflict(object, minimumGap(), objecti) >= 0
    )
    {
        return false;
    }
    space.move(objecti, object);
    return true;
}


Foam::label Foam::fsi::packedPlacement::addBetween
(
    packing& space,
    const boundBox& container,
    const label number
)
{
    label added = 0;
    for (label i = 0; i < attempts && added < number; ++i)
    {
        point centre(container.min());
        for (direction d = 0; d < nDims(); ++d)
        {
            centre[d] += container.span()[d]*random().sample01<scalar>();
        }
        const placedObject object(newObject(shape(), centre, randomRotation()));
        if
        (
            space.inside(object, container)
         && space.findConflict(object, minimumGap()) < 0
        )
        {
            space.insert(object);
            ++added;
        }
    }
    return added;
}


void Foam::fsi::packedPlacement::shake
(
    packing& space,
    const boundBox& container,
    const label first,
    const label number
)
{
    label n = space.size() - first, lastAdded = 0;
    scalar step = mag(space.shape(shape()).bounds().span());
    scalar angle = 90;
    const scalar largestStep = mag(container.span());

    // Smaller after few, larger after many successes
    const auto adapt = [&n](scalar& size, const label successes, scalar largest)
    {
        size = min(size*(successes > 0.4*n ? 1.1 : 0.9), largest);
    };

    for (label sweep = 0; sweep < sweeps_; ++sweep)
    {
        if (n < number)
        {
            const label added = addBetween(space, container, number - n);
            n += added;
            lastAdded = added ? sweep : lastAdded;
            if (sweep > lastAdded + patience)
            {
                return;
            }
        }
        label moved = 0, turned = 0;
        for (label objecti = first; objecti < space.size(); ++objecti)
        {
            const vector displacement = step*randomInBall();
            moved +=
                tryMove(space, container, objecti, displacement, tensor::I);
            const scalar degrees = angle*(2*random().sample01<scalar>() - 1);
            const tensor turn = randomTurn(random(), nDims(), degrees);
            turned += tryMove(space, container, objecti, Zero, turn);
        }
        adapt(step, moved, largestStep);
        adapt(angle, turned, 180);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::packedPlacement::packedPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    soughtPlacement(name, dict, space, {"sweeps"}),
    sweeps_(readBetween(dict, "sweeps", 500, 0, 1000000))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::packedPlacement::place(packing& space)
{
    const boundBox container(readContainer(space));
    const label number = readNumber(space);
    if (number == 0)
    {
        return;
    }

    pointField centres = bestSites(space, container);
    thin(centres, min(number, centres.size()));

    const label first = space.size();
    for (const point& centre : centres)
    {
        space.insert(newObject(shape(), centre, rotation()));
    }
    shake(space, container, first, number);
    if (space.size() < first + number)
    {
        lackRoom(space, number, space.size() - first, "");
    }
}


// ************************************************************************* //
