// SPDX-License-Identifier: GPL-3.0-or-later

#include "seeding.H"
#include "openfoamVersion.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::seeding::countNear
(
    const bool membranes,
    const scalar range,
    labelPair& first
) const
{
    label number = 0;
    for (label i = 0; i < space_->size() && range > 0; ++i)
    {
        // They touch what they are attached to, or nothing pushes them
        const label shapei = (*space_)[i].shape;
        if (space_->attached(shapei) || space_->immersed(shapei) != membranes)
        {
            continue;
        }
        const label other = space_->findConflict((*space_)[i], range, i);
        if (other >= 0 && number++ == 0)
        {
            first = labelPair(i, other);
        }
    }
    return number;
}


std::string Foam::fsi::seeding::describe(const labelPair& pair) const
{
    const closedSurface& surface = space_->surface(pair.first());
    OStringStream os;
    os  << "    The first is " << space_->description(pair.first()).c_str()
        << nl << "    with the gap "
        << space_->distance(surface, pair.second()) << " m to "
        << space_->description(pair.second()).c_str() << nl
        << "    Entry 'minimumGap' of a placement keeps them apart" << nl;
    return os.str();
}


void Foam::fsi::seeding::checkContacts() const
{
    labelPair pair;
    const label nTouching = countNear(false, domain_.contactRange, pair);
    if (nTouching)
    {
        WarningInFunction
            << nTouching << " objects are nearer to another than the range of"
            << " contact, " << domain_.contactRange
            << " m: their range is the gap at first, and laws that attract"
            << " push them from the start." << nl
            << describe(pair).c_str() << endl;
    }

    // A little less, against round-off
    const scalar gap = packing::membraneGap*domain_.spacing;
    const label nHooked = countNear(true, (1 - 1e-6)*gap, pair);
    if (nHooked)
    {
        WarningInFunction
            << nHooked << " membranes are nearer to another object than 0.3"
            << " cells, " << gap << " m: the fluid hardly parts them." << nl
            << describe(pair).c_str() << endl;
    }
}


void Foam::fsi::seeding::checkVelocities(const dictionary& placements) const
{
    for (label i = 0; i < space_->size(); ++i)
    {
        const placedObject& object = (*space_)[i];
        const scalar speed = mag(object.velocity) + mag(object.angularVelocity);
        const bool membrane = !objects_.groups()[object.shape].hasWalls();
        if ((space_->attached(object.shape) || membrane) && speed > 0)
        {
            FatalIOErrorInFunction(placements)
                << "Entry 'velocity' or 'angularVelocity' of placement "
                << object.placement << " in dictionary " << placements.name()
                << " gives " << space_->description(i).c_str()
                << " a velocity, but its shape "
                << (
                       membrane
                     ? "is a membrane, which moves with the fluid: set the"
                       " velocity in 0/U"
                     : "has a prescribed motion, or is clamped (entries"
                       " 'motion' and 'hold' of the shape)"
                   )
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
