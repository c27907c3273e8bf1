// SPDX-License-Identifier: GPL-3.0-or-later

#include "latticePlacement.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "rotations.H"
#include "Switch.H"
#include "addToRunTimeSelectionTable.H"
#include "readBetween.H"

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

void Foam::fsi::latticePlacement::readLattice(const packing& space)
{
    const vector span = region().span();
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
        counts_ = getEntry<Vector<label>>(dict(), "counts");
    }
    else
    {
        spacing_ = readFinite(dict(), "spacing");
    }

    for (direction d = 0; d < nDims(); ++d)
    {
        if (given ? counts_[d] < 1 : !(spacing_[d] > 0))
        {
            FatalIOErrorInFunction(dict())
                << "Entry '" << (given ? "counts" : "spacing")
                << "' in placement " << name() << " must be > 0 in x and y"
                << (nDims() == 3 ? " and z" : "") << exit(FatalIOError);
        }
    }
    checkNumber(space, given);

    for (direction d = 0; d < nDims(); ++d)
    {
        if (given)
        {
            spacing_[d] = span[d]/counts_[d];
        }
        else
        {
            // A whole number of spacings must not lose one to rounding
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
    if (nDims() == 2)
    {
        counts_.z() = 1;
    }
}


void Foam::fsi::latticePlacement::checkNumber
(
    const packing& space,
    const bool given
) const
{
    // Centres are in the region, objects may reach out of it
    const scalar reach = space.shape(shape()).bounds().mag() + jitter_;
    const vector margin(reach, reach, reach);
    scalar number = 1;
    for (direction d = 0; d < nDims(); ++d)
    {
        number *=
            given
          ? scalar(counts_[d])
          : max(std::floor(region().span()[d]/spacing_[d]), scalar(1));
    }
    checkRoom
    (
        space.shapeNames()[shape()],
        number,
        space.shape(shape()).volume(),
        boundBox(region().min() - margin, region().max() + margin),
        given ? "counts" : "spacing"
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::latticePlacement::latticePlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    regionPlacement
    (
        name,
        dict,
        space,
        {
            "counts", "spacing", "arrangement", "rotation",
            "randomRotation", "jitter"
        },
        0,
        0
    ),
    spacing_(Zero),
    counts_(1, 1, 1),
    staggered_
    (
        readChoice
        (
            dict, "arrangement", "rectangular", {"rectangular", "staggered"}
        ) == "staggered"
    ),
    rotation_(readRotation(dict, nDims())),
    randomRotation_(dict.lookupOrDefault<Switch>("randomRotation", false)),
    jitter_(readNonNegative(dict, "jitter", 0))
{
    setShape(readShape(dict, space));
    readLattice(space);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::latticePlacement::place(packing& space)
{
    const point middle = centreOf(region());

    DynamicList<placedObject> objects(cmptProduct(counts_));
    labelVector i;
    for (i.z() = 0; i.z() < counts_.z(); ++i.z())
    {
        for (i.y() = 0; i.y() < counts_.y(); ++i.y())
        {
            const bool second = (i.y() + i.z()) % 2;
            const scalar shift = staggered_ ? (second ? 0.25 : -0.25) : 0;
            for (i.x() = 0; i.x() < counts_.x(); ++i.x())
            {
                point centre(middle);
                for (direction d = 0; d < nDims(); ++d)
                {
                    const scalar place = d == 0 ? i[d] + shift : i[d];
                    centre[d] += (place - 0.5*(counts_[d] - 1))*spacing_[d];
                }
                if (jitter_ > 0)
                {
                    centre += jitter_*randomInBall();
                }
                objects.append
                (
                    newObject
                    (
                        shape(),
                        centre,
                        randomRotation_ ? randomRotation() : rotation_
                    )
                );
            }
        }
    }
    insertAll(space, objects, dict().found("counts") ? "counts" : "spacing");
}


// ************************************************************************* //
