// SPDX-License-Identifier: GPL-3.0-or-later

#include "soughtPlacement.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "rotations.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The keys of sought placements and some more
static wordList withSoughtKeys(const wordList& ownKeys, const word& fraction)
{
    wordList keys
    (
        {"shapes", "number", fraction, "rotation", "acrossCyclic"}
    );
    keys.append(ownKeys);
    return keys;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::boundBox Foam::fsi::soughtPlacement::readContainer
(
    const packing& space
) const
{
    vector gap(Zero);
    for (direction d = 0; d < nDims(); ++d)
    {
        gap[d] = wallGap();
    }
    return boundBox
    (
        max(region().min(), space.domain().min() + gap),
        min(region().max(), space.domain().max() - gap)
    );
}


Foam::scalar Foam::fsi::soughtPlacement::defaultGap
(
    const dictionary& dict,
    const packing& space
)
{
    const bool immersed = shapeMix(dict, space).immersed(space);
    return space.spacing()*(immersed ? packing::membraneGap : 3);
}


bool Foam::fsi::soughtPlacement::across
(
    const packing& space,
    const direction d
) const
{
    const boundBox& domain = space.domain();
    return
        acrossCyclic_ && d < nDims() && space.period()[d] > 0
     && region().min()[d] <= domain.min()[d]
     && region().max()[d] >= domain.max()[d];
}


bool Foam::fsi::soughtPlacement::held
(
    const packing& space,
    const boundBox& container,
    const placedObject& object
) const
{
    boundBox box(container);
    for (direction d = 0; d < nDims(); ++d)
    {
        if (across(space, d))
        {
            box.min()[d] = -GREAT;
            box.max()[d] = GREAT;
        }
    }
    return space.inside(object, box);
}


Foam::point Foam::fsi::soughtPlacement::wrapped
(
    const packing& space,
    point centre
) const
{
    const boundBox& domain = space.domain();
    for (direction d = 0; d < nDims(); ++d)
    {
        if (across(space, d))
        {
            const scalar period = space.period()[d];
            const scalar place = (centre[d] - domain.min()[d])/period;
            centre[d] -= period*std::floor(place);
        }
    }
    return centre;
}


Foam::point Foam::fsi::soughtPlacement::randomCentre
(
    const packing& space,
    const boundBox& container
)
{
    point centre(container.min());
    for (direction d = 0; d < nDims(); ++d)
    {
        const bool all = across(space, d);
        const scalar start = all ? space.domain().min()[d] : centre[d];
        const scalar length =
            all ? space.period()[d] : container.span()[d];
        centre[d] = start + length*random().sample01<scalar>();
    }
    return centre;
}


Foam::word Foam::fsi::soughtPlacement::fractionKey(const packing& space)
{
    return space.nDims() == 2 ? "areaFraction" : "volumeFraction";
}


Foam::word Foam::fsi::soughtPlacement::numberKey() const
{
    return
        dict().found("number") ? "number"
      : nDims() == 2 ? "areaFraction"
      : "volumeFraction";
}


Foam::label Foam::fsi::soughtPlacement::readNumber
(
    const packing& space
) const
{
    const word fraction(fractionKey(space));
    if (dict().found("number") == dict().found(fraction))
    {
        FatalIOErrorInFunction(dict())
            << "Placement " << name()
            << " needs either the entry 'number' or the entry '"
            << fraction << '\'' << exit(FatalIOError);
    }

    scalar number = 0;
    if (dict().found("number"))
    {
        number = readAtLeast(dict(), "number", 0, 0);
    }
    else
    {
        const scalar size = sizeOf(region(), nDims());
        number =
            readPositive(dict(), fraction)*size/mix_.meanVolume() + 0.5;
    }
    checkRoom
    (
        mix_.names(space), number, mix_.meanVolume(), readContainer(space),
        numberKey()
    );
    return label(number);
}


void Foam::fsi::soughtPlacement::checkFits
(
    const closedSurface& object,
    const boundBox& container
) const
{
    const vector size(object.bounds().span());
    for (direction d = 0; d < nDims(); ++d)
    {
        if (size[d] > container.span()[d])
        {
            FatalIOErrorInFunction(dict())
                << "There is no place for an object of placement " << name()
                << ": it is " << size[d] << " m long in direction " << label(d)
                << ", but the "
                << (dict().found("region") ? "entry 'region'" : "domain")
                << " less wallGap (" << wallGap() << " m) only "
                << max(container.span()[d], scalar(0)) << " m" << nl
                << "Take a smaller wallGap"
                << (dict().found("region") ? " or a larger region" : "")
                << exit(FatalIOError);
        }
    }
}


void Foam::fsi::soughtPlacement::lackRoom
(
    const packing& space,
    const label number,
    const string& reason
) const
{
    FatalIOErrorInFunction(dict())
        << "Entry '" << numberKey() << "' of placement " << name()
        << " asks for " << number << " objects of shape "
        << mix_.names(space).c_str() << " but " << reason.c_str() << nl
        << "Take fewer objects, a smaller minimumGap (" << minimumGap()
        << " m), a smaller wallGap (" << wallGap() << " m)"
        << (dict().found("region") ? ", a larger region" : "")
        << (type() == "packed" ? "" : ", or type packed")
        << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::soughtPlacement::soughtPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space,
    const wordList& ownKeys
)
:
    regionPlacement
    (
        name,
        dict,
        space,
        withSoughtKeys(ownKeys, fractionKey(space)),
        defaultGap(dict, space),
        readNonNegative(dict, "minimumGap", defaultGap(dict, space))
    ),
    mix_(dict, space),
    rotation_(readRotation(dict, nDims())),
    acrossCyclic_
    (
        dict.lookupOrDefault<Switch>("acrossCyclic", mix_.immersed(space))
    )
{
    setShape(mix_.largest());
}


// ************************************************************************* //
