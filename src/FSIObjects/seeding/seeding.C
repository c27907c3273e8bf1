// SPDX-License-Identifier: GPL-3.0-or-later

#include "seeding.H"
#include "dictionaryCheck.H"
#include "nameCheck.H"
#include "outlineThickness.H"
#include "placement.H"
#include "shape.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::seeding::addShapes(const dictionary& dict)
{
    List<outline> outlines;
    wordList names;
    DynamicList<bool> prescribed;
    for (const entry& e : dict)
    {
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
        outlines.append(outline(shape.points(), shape.faces()));
        names.append(shape.name());
        prescribed.append(!objects_.groups().last().free());
        checkThickness(e.dict(), outlines.last());
    }
    space_.reset
    (
        new packing
        (
            domain_.bounds,
            domain_.spacing,
            names,
            outlines,
            domain_.period,
            boolList(prescribed)
        )
    );
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
    checkArea(dict);
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
                nodeSpacing,
                domain_.thickness,
                domain_.nDims
            )
        ),
        dict.subOrEmptyDict("motion")
    );
}


void Foam::fsi::seeding::checkArea(const dictionary& dict) const
{
    const scalar area =
        shape::New(dict.subDict("shape"), domain_.nDims)->volume();
    const vector span = domain_.bounds.span();
    if (area > span.x()*span.y())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape' of dictionary " << dict.name()
            << " describes an object of " << area
            << " m2, which is more than that of the domain, "
            << span.x()*span.y() << " m2" << exit(FatalIOError);
    }
}


void Foam::fsi::seeding::checkThickness
(
    const dictionary& dict,
    const outline& shape
) const
{
    const scalar cells = readNonNegative(dict, "minimumCells", 3);
    const scalar least = cells*domain_.spacing;
    const scalar thickness = outlineThickness::smallest(shape.points());
    if (thickness < least)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape' of dictionary " << dict.name()
            << " describes an object that is " << thickness
            << " m thick at its thinnest, which is less than " << cells
            << " cells, " << least << " m (entry 'minimumCells')" << nl
            << "Take a finer mesh or a larger shape; a smaller minimumCells"
            << " is at your own risk"
            << exit(FatalIOError);
    }
}


void Foam::fsi::seeding::place(const dictionary& dict)
{
    for (const entry& e : dict)
    {
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
            space_->objectOutline(i), domain_.contactRange, i
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
            space_->distance(space_->objectOutline(first), other);
        WarningInFunction
            << nTouching << " objects are nearer to another than the range of"
            << " contact, " << domain_.contactRange
            << " m: they push each other from the start." << nl
            << "    The first is " << space_->description(first).c_str() << nl
            << "    with the gap " << gap << " m to "
            << space_->description(other).c_str() << nl
            << "    Entry 'minimumGap' of a placement keeps them apart" << nl
            << endl;
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
    objects_(time, domain.nDims, domain.bounds.centre().z())
{
    if (domain_.nDims != 2)
    {
        FatalErrorInFunction
            << "Objects can be seeded in two dimensions only so far"
            << exit(FatalError);
    }
    checkKeys(dict, {"FoamFile", "shapes", "placements"});
    addShapes(dict.subDict("shapes"));
    place(dict.subDict("placements"));
    checkContacts();
    populate();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::seeding::report(Ostream& os) const
{
    const vector span = domain_.bounds.span();
    const scalar domainArea = span.x()*span.y();

    scalar sumArea = 0;
    forAll(objects_.groups(), groupi)
    {
        const bodyGroup& group = objects_.groups()[groupi];
        const shapeTemplate& shape = group.shape();
        const scalar area = group.size()*shape.referenceVolume();
        sumArea += area;
        os  << "    " << shape.name() << ": " << group.size() << " objects of "
            << shape.nNodes() << " nodes (" << shape.nBoundaryNodes()
            << " on the boundary), area " << shape.referenceVolume()
            << " m2, mass " << shape.mass() << " kg, "
            << (group.free() ? "free" : "prescribed motion")
            << ", area fraction " << area/domainArea << nl;
    }
    os  << "    all: " << objects_.size() << " objects, "
        << objects_.nNodes() << " nodes, "
        << objects_.surfaces().points().size() << " on the boundary"
        << ", area fraction " << sumArea/domainArea << endl;
}


// ************************************************************************* //
