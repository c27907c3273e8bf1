// SPDX-License-Identifier: GPL-3.0-or-later

#include "regionPlacement.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Unit of an area or a volume
static const char* unitOf(const direction nDims)
{
    return nDims == 2 ? " m2" : " m3";
}


//- The keys that are given, and `region`
static wordList withRegion(const wordList& ownKeys)
{
    wordList keys(ownKeys);
    keys.append("region");
    return keys;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::regionPlacement::sizeOf
(
    const boundBox& box,
    const direction nDims
)
{
    scalar size = 1;
    for (direction d = 0; d < nDims; ++d)
    {
        size *= max(box.span()[d], scalar(0));
    }
    return size;
}


Foam::boundBox Foam::fsi::regionPlacement::readRegion
(
    const packing& space
) const
{
    if (!dict().found("region"))
    {
        return space.domain();
    }

    const dictionary& region = dict().subDict("region");
    checkKeys(region, {"min", "max"});
    const boundBox box
    (
        readFinite(region, "min"), readFinite(region, "max")
    );
    const boundBox& domain = space.domain();
    bool inside = true;
    for (direction d = 0; d < nDims(); ++d)
    {
        const scalar rounding = 1e-6*domain.span()[d];
        inside =
            inside
         && box.min()[d] >= domain.min()[d] - rounding
         && box.max()[d] <= domain.max()[d] + rounding;
    }
    if (!(sizeOf(box, nDims()) > 0) || !inside)
    {
        FatalIOErrorInFunction(region)
            << "The box of entry 'region' in placement " << name() << " is "
            << box.min() << ' ' << box.max()
            << " but must have min < max and lie in the domain "
            << domain.min() << ' ' << domain.max()
            << exit(FatalIOError);
    }
    return box;
}


void Foam::fsi::regionPlacement::checkRoom
(
    const string& shapes,
    const scalar number,
    const scalar own,
    const boundBox& box,
    const word& key
) const
{
    const scalar size = sizeOf(box, nDims());
    if (number >= 1 && number*own > size*(1 + SMALL))
    {
        FatalIOErrorInFunction(dict())
            << "Entry '" << key << "' of placement " << name()
            << " asks for " << number << " objects of shape "
            << shapes.c_str() << ", " << number*own
            << unitOf(nDims()) << " together, but there is no room for more"
            << " than the " << size << unitOf(nDims()) << " from " << box.min()
            << " to " << box.max() << nl << "Take fewer objects, a smaller"
            << " shape, a larger region or a smaller wallGap (" << wallGap()
            << " m)" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::regionPlacement::regionPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space,
    const wordList& ownKeys,
    const scalar defaultMinimumGap,
    const scalar defaultWallGap
)
:
    placement
    (
        name,
        dict,
        space,
        withRegion(ownKeys),
        defaultMinimumGap,
        defaultWallGap
    ),
    shape_(-1),
    region_(readRegion(space))
{}


// ************************************************************************* //
