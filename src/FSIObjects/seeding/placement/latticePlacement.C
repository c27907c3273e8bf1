// SPDX-License-Identifier: GPL-3.0-or-later

#include "latticePlacement.H"
#include "dictionaryCheck.H"
#include "Switch.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(latticePlacement, 0);
    addToRunTimeSelectionTable(placement, latticePlacement, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::latticePlacement::readLattice()
{
    const vector span = region_.span();
    if (dict().found("counts") == dict().found("spacing"))
    {
        FatalIOErrorInFunction(dict())
            << "Placement " << name()
            << " needs either the entry 'counts' or the entry 'spacing'"
            << exit(FatalIOError);
    }

    const bool given = dict().found("counts");
    if (given)
    {
        counts_ = dict().get<Vector<label>>("counts");
    }
    else
    {
        spacing_ = dict().get<vector>("spacing");
    }

    for (direction d = 0; d < 2; ++d)
    {
        if (given ? counts_[d] < 1 : !(spacing_[d] > 0))
        {
            FatalIOErrorInFunction(dict())
                << "Entry '" << (given ? "counts" : "spacing")
                << "' in placement " << name() << " must be > 0 in x and y"
                << exit(FatalIOError);
        }
        if (given)
        {
            spacing_[d] = span[d]/counts_[d];
        }
        else
        {
            // Of a length that is a whole number of spacings nothing is lost
            counts_[d] = label(span[d]/spacing_[d]*(1 + SMALL) + SMALL);
        }
        if (counts_[d] < 1)
        {
            FatalIOErrorInFunction(dict())
                << "Entry 'spacing' in placement " << name() << " is "
                << spacing_[d] << " m in direction " << label(d)
                << " but its region is only " << span[d] << " m long"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::latticePlacement::latticePlacement
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
        {
            "region", "counts", "spacing", "arrangement", "rotation",
            "randomRotation", "jitter"
        },
        0,
        0
    ),
    shape_(readShape(dict, space)),
    region_(readRegion(space)),
    spacing_(Zero),
    counts_(1, 1, 1),
    staggered_
    (
        readChoice
        (
            dict, "arrangement", "rectangular", {"rectangular", "staggered"}
        ) == "staggered"
    ),
    rotation_(dict.lookupOrDefault<scalar>("rotation", 0)),
    randomRotation_(dict.lookupOrDefault<Switch>("randomRotation", false)),
    jitter_(readNonNegative(dict, "jitter", 0))
{
    readLattice();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::latticePlacement::place(packing& space)
{
    const point middle = region_.centre();

    DynamicList<placedObject> objects(counts_.x()*counts_.y());
    for (label j = 0; j < counts_.y(); ++j)
    {
        const scalar shift = staggered_ ? (j % 2 ? 0.25 : -0.25) : 0;
        for (label i = 0; i < counts_.x(); ++i)
        {
            point centre
            (
                middle.x()
              + (i + shift - 0.5*(counts_.x() - 1))*spacing_.x(),
                middle.y() + (j - 0.5*(counts_.y() - 1))*spacing_.y(),
                middle.z()
            );
            if (jitter_ > 0)
            {
                centre += jitter_*randomInDisc();
            }
            objects.append
            (
                newObject
                (
                    shape_,
                    centre,
                    randomRotation_ ? randomRotation() : rotation(rotation_)
                )
            );
        }
    }
    insertAll(space, objects, dict().found("counts") ? "counts" : "spacing");
}


// ************************************************************************* //
