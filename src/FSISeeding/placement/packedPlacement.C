// SPDX-License-Identifier: GPL-3.0-or-later

#include "packedPlacement.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "OStringStream.H"
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

    //- Size at first of objects that grow, over their own
    static const scalar firstScale = 0.5;
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
    const tensor& turn,
    const scalar growth
)
{
    placedObject object = space[objecti];
    object.centre = wrapped(space, object.centre + displacement);
    object.rotation = turn & object.rotation;
    object.scale = min(growth*object.scale, scalar(1));
    if
    (
        !held(space, container, object)
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
    const labelUList& shapes
)
{
    label added = 0;
    for (label i = 0; i < attempts && added < shapes.size(); ++i)
    {
        const point centre(randomCentre(space, container));
        placedObject object
        (
            newObject(shapes[added], centre, randomRotation())
        );
        object.scale = grows_ ? firstScale : 1;
        if
        (
            held(space, container, object)
         && space.findConflict(object, minimumGap()) < 0
        )
        {
            space.insert(object);
            ++added;
        }
    }
    return added;
}


void Foam::fsi::packedPlacement::sweep
(
    packing& space,
    const boundBox& container,
    const label first,
    moveSizes& sizes
)
{
    label moved = 0, turned = 0, grown = 0, growing = 0;
    scalar mean = 0;
    for (label objecti = first; objecti < space.size(); ++objecti)
    {
        mean += space[objecti].scale/(space.size() - first);
    }
    for (label objecti = first; objecti < space.size(); ++objecti)
    {
        const auto attempt = [&](const vector& d, const tensor& t, scalar g)
        {
            return tryMove(space, container, objecti, d, t, g);
        };
        moved += attempt(sizes.step*randomInBall(), tensor::I, 1);
        const scalar degrees =
            sizes.angle*(2*random().sample01<scalar>() - 1);
        turned += attempt(Zero, randomTurn(random(), nDims(), degrees), 1);
        if (space[objecti].scale < min(1.05*mean, scalar(1)))
        {
            ++growing;
            grown += attempt(Zero, tensor::I, 1 + sizes.growth);
        }
    }

    // Smaller after few, larger after many successes
    const auto adapt = [](scalar& size, label successes, scalar n, scalar most)
    {
        size = min(size*(successes > 0.4*n ? 1.1 : 0.9), most);
    };
    const label n = space.size() - first;
    adapt(sizes.step, moved, n, mag(container.span()));
    adapt(sizes.angle, turned, n, 180);
    adapt(sizes.growth, grown, 0.4*growing, 0.5);
}


void Foam::fsi::packedPlacement::shake
(
    packing& space,
    const boundBox& container,
    const label first,
    const labelUList& shapes
)
{
    const label number = shapes.size();
    label n = space.size() - first, lastAdded = 0;
    moveSizes sizes;
    sizes.step = mag(space.shape(shape()).bounds().span());
    for (label sweepi = 0; sweepi < sweeps_; ++sweepi)
    {
        if (n < number)
        {
            const label added = addBetween
            (
                space, container, SubList<label>(shapes, number - n, n)
            );
            n += added;
            lastAdded = added ? sweepi : lastAdded;
            if (sweepi > lastAdded + patience)
            {
                return;
            }
        }
        sweep(space, container, first, sizes);
        if (grows_ && n == number && leastScale(space, first) >= 1)
        {
            return;
        }
    }
}


Foam::scalar Foam::fsi::packedPlacement::leastScale
(
    const packing& space,
    const label first
)
{
    scalar least = 1;
    for (label objecti = first; objecti < space.size(); ++objecti)
    {
        least = min(least, space[objecti].scale);
    }
    return least;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::packedPlacement::packedPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    soughtPlacement(name, dict, space, {"sweeps", "start"}),
    sweeps_(readBetween(dict, "sweeps", 500, 0, 1000000)),
    grows_
    (
        readChoice(dict, "start", "lattice", {"lattice", "small"}) == "small"
    )
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

    pointField centres;
    if (!grows_)
    {
        centres = bestSites(space, container);
        thin(centres, min(number, centres.size()));
    }

    const label first = space.size();
    const labelList shapes(shapesOf(number));
    forAll(centres, i)
    {
        space.insert(newObject(shapes[i], centres[i], rotation()));
    }
    shake(space, container, first, shapes);
    const label found = space.size() - first;
    const scalar least = leastScale(space, first);
    OStringStream reason;
    if (found < number)
    {
        reason << "there is no room for more than " << found;
        if (grows_)
        {
            reason << ", at " << firstScale << " of their size (start small)";
        }
    }
    else if (least < 1)
    {
        reason
            << "after " << sweeps_ << " sweeps (sweeps) the smallest of them"
            << " had grown only to " << least << " of its size (start small)";
    }
    if (!reason.str().empty())
    {
        lackRoom(space, number, reason.str());
    }
}


// ************************************************************************* //
