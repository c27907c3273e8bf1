// SPDX-License-Identifier: GPL-3.0-or-later

#include "openBoundaries.H"
#include "errorOf.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The one of some patches that is nearest to a point. All ranks must call
static const word& nearestPatch
(
    const polyBoundaryMesh& patches,
    const wordList& names,
    const point& p
)
{
    scalarField nearest(names.size(), GREAT);
    forAll(names, i)
    {
        const label patchi = patchOf(patches, names[i]);
        for (label j = 0; patchi >= 0 && j < patches[patchi].size(); ++j)
        {
            const scalar away = magSqr(patches[patchi].faceCentres()[j] - p);
            nearest[i] = min(nearest[i], away);
        }
    }
    combineOverRanks(nearest, minEqOp<scalar>());
    return names[findIndex(nearest, min(nearest))];
}

} // End namespace fsi
} // End namespace Foam

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::openBoundaries::sideLeft(const label objecti) const
{
    const boundBox box(objects_.surfaces().bounds(objecti));
    const bodyGroup& group = objects_.groups()[objects_.objectGroup(objecti)];
    for (label sidei = 0; sidei < 2*objects_.nDims(); ++sidei)
    {
        const scalar beyond = sides_.beyond(sidei, box);
        if (beyond <= 0)
        {
            continue;
        }
        if
        (
            sides_[sidei] == domainSides::WALL
         && sides_.behindWall(pointField(1, centreOf(box)))
        )
        {
            FatalErrorInFunction
                << "Object " << objects_.objectId(objecti) << " of shape "
                << group.shape().name() << ", from " << box.min() << " to "
                << box.max() << ", is wholly outside the domain "
                << sides_.bounds() << ", beyond a wall"
                << exit(FatalError);
        }
        const vector v(group.velocity(objects_.objectCopy(objecti)));
        if
        (
            beyond > grid_.spacing()
         && sides_.isOpen(sidei)
         && (v & domainSides::outward(sidei)) >= 0
        )
        {
            return sidei;
        }
    }
    return -1;
}


Foam::label Foam::fsi::openBoundaries::feedAt
(
    const label sidei,
    const point& p
) const
{
    forAll(feeds_, i)
    {
        if
        (
            findIndex(sides_.patches(sidei), feeds_[i].patch()) >= 0
         && feeds_[i].isBefore(p)
        )
        {
            return i;
        }
    }
    return -1;
}


void Foam::fsi::openBoundaries::warn(const label feedi)
{
    if (feedi >= 0)
    {
        ++nWarnings_;
        WarningInFunction
            << "Patch " << feeds_[feedi].patch() << " feeds objects: one that"
            << " leaves through it has been pushed out by the flow." << nl
            << "    Feed later (startTime), when the flow has settled"
            << endl;
    }
}


bool Foam::fsi::openBoundaries::removeObjects(const scalar time)
{
    DynamicList<label> leaving;
    DynamicList<scalar> mine;
    for (label objecti = 0; objecti < objects_.size(); ++objecti)
    {
        const label sidei = sideLeft(objecti);
        if (sidei >= 0)
        {
            const label groupi = objects_.objectGroup(objecti);
            const label copyi = objects_.objectCopy(objecti);
            const vector p(objects_.groups()[groupi].centroid(copyi));
            const vector v(objects_.groups()[groupi].velocity(copyi));
            leaving.append(objecti);
            mine.append(groupi);
            mine.append(objects_.objectId(objecti));
            mine.append(sidei);
            mine.append(feedAt(sidei, p));
            for (const vector& x : {p, v})
            {
                mine.append(x.x());
                mine.append(x.y());
                mine.append(x.z());
            }
        }
    }
    if (objects_.ranks().largest(leaving.size()) == 0)
    {
        return false;
    }

    // All ranks count and tell in the same order
    const scalarList numbers(objects_.ranks().gathered(scalarList(mine)));
    std::map<labelPair, label> order;
    for (label i = 0; i < numbers.size(); i += 10)
    {
        order[labelPair(label(numbers[i]), label(numbers[i + 1]))] = i;
    }
    for (const auto& left : order)
    {
        const scalar* of = &numbers[left.second];
        const label sidei = label(of[2]);
        const word& shape = objects_.shape(left.first.first()).name();
        const point p(of[4], of[5], of[6]);
        const word& patch = nearestPatch
        (
            grid_.mesh().boundaryMesh(), sides_.patches(sidei), p
        );
        ++removed_[sidei];
        Info<< "Object " << left.first.second() << " of shape " << shape
            << " left through " << patch << ", " << removed_[sidei]
            << " so far" << endl;
        if (table_.valid())
        {
            table_().row() << time << left.first.second() << shape << patch
                << p << vector(of[7], of[8], of[9]);
        }
        warn(label(of[3]));
    }
    objects_.remove(leaving);
    return true;
}


// ************************************************************************* //
