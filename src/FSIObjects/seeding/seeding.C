// SPDX-License-Identifier: GPL-3.0-or-later

#include "seeding.H"
#include "bodyMotion.H"
#include "dictionaryCheck.H"
#include "nameCheck.H"
#include "newShapeMesh.H"
#include "openfoamVersion.H"
#include "placement.H"
#include "shapeCheck.H"
#include "userVariables.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::seeding::addShapes(const dictionary& dict)
{
    List<closedSurface> surfaces;
    wordList names;
    boolList prescribed;
    for (const entry& e : dict)
    {
        if (userVariables::isAside(dict, e, {"shape", "material"}))
        {
            continue;
        }
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' in dictionary "
                << dict.name() << " must be the dictionary of a shape"
                << exit(FatalIOError);
        }
        checkName(dict, e.keyword());
        addShape(e.dict());

        const shapeTemplate& shape = objects_.groups().last().shape();
        surfaces.append
        (
            closedSurface
            (
                SubList<point>(shape.points(), shape.nBoundaryNodes()),
                shape.faces()
            )
        );
        names.append(shape.name());
        prescribed.append(!objects_.groups().last().movesFreely());
    }
    space_.reset
    (
        new packing
        (
            domain_.bounds,
            domain_.spacing,
            names,
            surfaces,
            domain_.period,
            prescribed
        )
    );
}


bool Foam::fsi::seeding::needsInside(const dictionary& dict) const
{
    const word type
    (
        dict.subDict("material").lookupOrDefault<word>("type", "")
    );
    const bool solid = domain_.nDims == 3;
    const bool prescribed =
        bodyMotion::New(dict.subOrEmptyDict("motion")).valid();
    return type != "rigid" && !(solid && prescribed);
}


void Foam::fsi::seeding::addShape(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "shape", "mesh", "material", "admm",
            "nodeSpacing", "minimumCells", "motion"
        }
    );
    checkSubDicts(dict, {"shape", "mesh", "material", "admm", "motion"});
    checkShape(dict, domain_);
    const scalar nodeSpacing =
        readPositive(dict, "nodeSpacing", domain_.spacing);
    if (nodeSpacing < 0.65*domain_.spacing)
    {
        WarningInFunction
            << "Nodes of shape " << dict.dictName() << " are " << nodeSpacing
            << " m apart, cells " << domain_.spacing << " m: some nodes do not"
            << " meet the fluid then, and soft bodies may become unstable"
            << nl
            << "    Let nodeSpacing be " << domain_.spacing/1.5 << " m or more"
            << nl << endl;
    }

    dictionary shapeDict(dict);
    shapeDict.remove("nodeSpacing");
    shapeDict.remove("minimumCells");
    shapeDict.remove("motion");

    objects_.addShape
    (
        autoPtr<shapeTemplate>
        (
            new shapeTemplate
            (
                dict.dictName(),
                shapeDict,
                newShapeMesh
                (
                    dict.subDict("shape"),
                    domain_.nDims,
                    nodeSpacing,
                    meshGrading(dict.subOrEmptyDict("mesh")),
                    needsInside(dict)
                ),
                nodeSpacing,
                domain_.thickness,
                domain_.nDims
            )
        ),
        dict.subOrEmptyDict("motion")
    );
}


void Foam::fsi::seeding::place(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        if (userVariables::isAside(dict, e, {"type", "shape"}))
        {
            continue;
        }
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' in dictionary "
                << dict.name() << " must be the dictionary of a placement"
                << exit(FatalIOError);
        }
        placement::New(e.keyword(), e.dict(), *space_)->place(*space_);
    }
}


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
            space_->surface(i), domain_.contactRange, i
        );
        if (found >= 0 && nTouching++ == 0)
        {
            first = i;
            other = found;
        }
    }
    if (nTouching)
    {
        const scalar gap =
            space_->distance(space_->surface(first), other);
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


void Foam::fsi::seeding::populate()
{
    const label n = space_->size();
    labelList groups(n);
    pointField centres(n);
    tensorField rotations(n);
    vectorField velocities(n), angularVelocities(n);
    for (label i = 0; i < n; ++i)
    {
        const placedObject& object = (*space_)[i];
        groups[i] = object.shape;
        centres[i] = object.centre;
        rotations[i] = object.rotation;
        velocities[i] = object.velocity;
        angularVelocities[i] = object.angularVelocity;
    }
    objects_.append(groups, centres, rotations, velocities, angularVelocities);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::seeding::seeding
(
    const Time& time,
    const seedDomain& domain,
    const dictionary& dict
)
:
    domain_(domain),
    objects_(time, domain.nDims, centreOf(domain.bounds).z())
{
    userVariables::checkFileKeys(dict, {"FoamFile", "shapes", "placements"});
    addShapes(dict.subDict("shapes"));
    place(dict.subDict("placements"));
    checkVelocities(dict.subDict("placements"));
    checkContacts();
    populate();
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
        if (free)
        {
            os  << "free" << fraction << ofShape/domain_.size() << nl;
        }
        else
        {
            // Obstacles may reach beyond the domain
            os  << "prescribed motion" << nl;
        }
    }
    os  << "    all: " << objects_.size() << " objects, "
        << objects_.nNodes() << " nodes, "
        << objects_.surfaces().points().size() << " on the boundary"
        << fraction << sum/domain_.size() << " of the free ones" << endl;
}


// ************************************************************************* //
