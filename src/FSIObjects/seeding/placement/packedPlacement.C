// SPDX-License-Identifier: GPL-3.0-or-later

#include "packedPlacement.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(packedPlacement, 0);
    addToRunTimeSelectionTable(placement, packedPlacement, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::packedPlacement::rowDistance
(
    const outline& object,
    const scalar pitch,
    const scalar rectangular
) const
{
    const auto fits = [&](const scalar x, const scalar y)
    {
        return !object.closerThan
        (
            object.moved(tensor::I, vector(x, y, 0)), minimumGap()
        );
    };

    // From above, so that rows do not slip past each other
    const label nSteps = 500;
    scalar distance = rectangular;
    for (label i = nSteps; i > 0; --i)
    {
        const scalar y = rectangular*i/nSteps;
        if (!fits(0.5*pitch, y) || !fits(-0.5*pitch, y) || !fits(0, 2*y))
        {
            break;
        }
        distance = y;
    }
    return distance;
}


Foam::pointField Foam::fsi::packedPlacement::sites
(
    const packing& space,
    const boundBox& container,
    const outline& object,
    const bool staggered
) const
{
    // A little more than the gap, against round-off
    const vector size = object.bounds().span();
    const scalar gap = minimumGap()*(1 + 1e-6) + 1e-9*mag(size);
    const scalar pitch = size.x() + gap;
    const scalar rectangular = size.y() + gap;
    const scalar row =
        staggered ? rowDistance(object, pitch, rectangular) : rectangular;

    // Centre of the first object
    const point start(container.min() - object.bounds().min());
    const vector room(container.span() - size);

    DynamicList<point> found;
    for (label j = 0; j*row <= room.y(); ++j)
    {
        const scalar shift = staggered && j % 2 ? 0.5 : 0;
        for (label i = 0; (i + shift)*pitch <= room.x(); ++i)
        {
            const point site =
                start + vector((i + shift)*pitch, j*row, -start.z());
            const outline candidate = object.moved(tensor::I, site);
            if (space.findConflict(candidate, minimumGap()) < 0)
            {
                found.append(site);
            }
        }
    }
    return pointField(std::move(found));
}


void Foam::fsi::packedPlacement::thin(pointField& sites, const label number)
{
    // The first ones of a random order, as far as it is needed
    for (label i = 0; i < number; ++i)
    {
        const label j = random().position<label>(i, sites.size() - 1);
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

    const outline candidate = space.placedOutline(object);
    if
    (
        !packing::inside(candidate, container, 0)
     || space.findConflict(candidate, minimumGap(), objecti) >= 0
    )
    {
        return false;
    }
    space.move(objecti, object.centre, object.rotation, candidate);
    return true;
}


void Foam::fsi::packedPlacement::shake
(
    packing& space,
    const boundBox& container,
    const label first
)
{
    const label n = space.size() - first;
    scalar step = mag(space.shape(shape_).bounds().span());
    scalar angle = 90;
    const scalar largestStep = mag(container.span());

    // Smaller after few, larger after many successes
    const auto adapt = [n](scalar& size, const label successes, scalar largest)
    {
        size = min(size*(successes > 0.4*n ? 1.1 : 0.9), largest);
    };

    for (label sweep = 0; sweep < sweeps_; ++sweep)
    {
        label moved = 0, turned = 0;
        for (label objecti = first; objecti < space.size(); ++objecti)
        {
            const vector displacement = step*randomInDisc();
            moved +=
                tryMove(space, container, objecti, displacement, tensor::I);
            const tensor turn =
                rotation(angle*(2*random().sample01<scalar>() - 1));
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
    placement
    (
        name,
        dict,
        {"region", "number", "areaFraction", "rotation", "sweeps"},
        3*space.spacing(),
        dict.lookupOrDefault<scalar>("minimumGap", 3*space.spacing())
    ),
    shape_(readShape(dict, space)),
    rotation_(rotation(dict.lookupOrDefault<scalar>("rotation", 0))),
    sweeps_(readAtLeast(dict, "sweeps", 500, 0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::packedPlacement::place(packing& space)
{
    const boundBox container(readContainer(space));
    const label number = readNumber(space, shape_);
    const outline object = space.shape(shape_).moved(rotation_, Zero);

    pointField centres = sites(space, container, object, false);
    const pointField staggered = sites(space, container, object, true);
    if (staggered.size() > centres.size())
    {
        centres = staggered;
    }
    if (centres.size() < number)
    {
        FatalIOErrorInFunction(dict())
            << "Entry '" << (dict().found("number") ? "number" : "areaFraction")
            << "' of placement " << name() << " asks for " << number
            << " objects of shape " << space.shapeNames()[shape_]
            << " but there is no room for more than " << centres.size() << nl
            << "Take fewer objects or a smaller minimumGap ("
            << minimumGap() << " m)" << exit(FatalIOError);
    }
    thin(centres, number);

    const label first = space.size();
    for (const point& centre : centres)
    {
        space.insert(newObject(shape_, centre, rotation_));
    }
    shake(space, container, first);
}


// ************************************************************************* //
