// SPDX-License-Identifier: GPL-3.0-or-later

#include "seeding.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::seeding::checkContacts() const
{
    label nTouching = 0, first = -1, other = -1;
    for (label i = 0; i < space_->size() && domain_.contactRange > 0; ++i)
    {
        // Nothing pushes objects with a prescribed motion
        if (space_->attached((*space_)[i].shape))
        {
            continue;
        }
        const label found = space_->findConflict
        (
            (*space_)[i], domain_.contactRange, i
        );
        if (found >= 0 && nTouching++ == 0)
        {
            first = i;
            other = found;
        }
    }
    if (nTouching)
    {
        const scalar gap = space_->distance(space_->surface(first), other);
        WarningInFunction
            << nTouching << " objects are nearer to another than the range of"
            << " contact, " << domain_.contactRange
            << " m: their range is the gap at first, and laws that attract"
            << " push them from the start." << nl
            << "    The first is " << space_->description(first).c_str() << nl
            << "    with the gap " << gap << " m to "
            << space_->description(other).c_str() << nl
            << "    Entry 'minimumGap' of a placement keeps them apart" << nl
            << endl;
    }
}


void Foam::fsi::seeding::checkVelocities(const dictionary& placements) const
{
    for (label i = 0; i < space_->size(); ++i)
    {
        const placedObject& object = (*space_)[i];
        const scalar speed = mag(object.velocity) + mag(object.angularVelocity);
        if (space_->attached(object.shape) && speed > 0)
        {
            FatalIOErrorInFunction(placements)
                << "Entry 'velocity' or 'angularVelocity' of placement "
                << object.placement << " in dictionary " << placements.name()
                << " gives " << space_->description(i).c_str()
                << " a velocity, but its shape has a prescribed motion: give"
                << " the velocity there (entry 'motion' of the shape)"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::seeding::report(Ostream& os) const
{
    const bool plane = domain_.nDims == 2;
    const char* size = plane ? "area " : "volume ";
    const char* unit = plane ? " m2" : " m3";
    const char* fraction = plane ? ", area fraction " : ", volume fraction ";
    scalar sum = 0;
    forAll(objects_.groups(), groupi)
    {
        const bodyGroup& group = objects_.groups()[groupi];
        const shapeTemplate& shape = group.shape();
        const bool free = group.movesFreely();
        const scalar ofShape = group.size()*shape.referenceVolume();
        sum += free ? ofShape : 0;
        os  << "    " << shape.name() << ": " << group.size() << " objects of "
            << shape.nNodes() << " nodes (" << shape.nBoundaryNodes()
            << " on the boundary), " << size << shape.referenceVolume()
            << unit << ", mass " << shape.mass() << " kg, ";
        // Obstacles may reach beyond the domain
        free
      ? os << "free" << fraction << ofShape/domain_.size() << nl
      : os << "prescribed motion" << nl;
    }
    os  << "    all: " << objects_.size() << " objects, "
        << objects_.nNodes() << " nodes, "
        << objects_.surfaces().points().size() << " on the boundary"
        << fraction << sum/domain_.size() << " of the free ones" << endl;
}


// ************************************************************************* //
