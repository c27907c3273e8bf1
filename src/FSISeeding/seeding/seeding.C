// SPDX-License-Identifier: GPL-3.0-or-later

#include "seeding.H"
#include "bodyMotion.H"
#include "cpuTime.H"
#include "dictionaryCheck.H"
#include "nameCheck.H"
#include "newShapeMesh.H"
#include "openfoamVersion.H"
#include "placement.H"
#include "scaledShape.H"
#include "shape.H"
#include "shapeCheck.H"
#include "shapeClasses.H"
#include "surfaceFile.H"
#include "userVariables.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- FatalIOError unless an entry is the dictionary of a shape
static void checkShapeEntry(const dictionary& dict, const entry& e)
{
    const dictionary& own = dictOf(dict, e, "shape");
    checkName(dict, e.keyword());
    checkKeys
    (
        own,
        {
            "shape", "mesh", "material", "admm", "hold", "follow",
            "nodeSpacing", "minimumCells", "motion", "distribution"
        }
    );
    checkSubDicts
    (
        own,
        {
            "shape", "mesh", "material", "admm", "hold", "follow", "motion",
            "distribution"
        }
    );
}


//- Call an action for each shape of an entry, with its name and dictionary:
//  one, the classes of a distribution, or the pieces of a file
static void forShapes
(
    const entry& e,
    const direction nDims,
    const std::function<void(const word&, const dictionary&, const shape&)>&
        action
)
{
    const dictionary& dict = e.dict();
    const dictionary& shapeDict = dict.subDict("shape");
    const word stem(e.keyword() + '_');
    if (dict.found("distribution"))
    {
        const shapeClasses classes(dict);
        const autoPtr<shape> original(shape::New(shapeDict, nDims));
        for (label i = 0; i < classes.size(); ++i)
        {
            const scaledShape body(original(), classes.sizeOf(i), nDims);
            action(stem + Foam::name(i + 1), classes.dictOf(i), body);
        }
        return;
    }
    if
    (
        nDims == 3
     && shapeDict.lookupOrDefault<word>("type", "") == "surface"
    )
    {
        const PtrList<shape> pieces(surfaceFile::allPieces(shapeDict));
        forAll(pieces, i)
        {
            action(stem + Foam::name(i + 1), dict, pieces[i]);
        }
        if (pieces.size())
        {
            return;
        }
    }
    action(e.keyword(), dict, *shape::New(shapeDict, nDims));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::seeding::addShapes(const dictionary& dict)
{
    List<closedSurface> surfaces;
    wordList names;
    boolList attached, immersed;
    pointField places;
    const auto add = [&](const word& name, const dictionary& d, const shape& b)
    {
        addShape(name, d, b);
        const shapeTemplate& shape = objects_.groups().last().shape();
        surfaces.append
        (
            closedSurface(shape.boundaryPoints(), shape.faces())
        );
        names.append(shape.name());
        attached.append
        (
            !objects_.groups().last().movesFreely()
         || shape.held().clamped().size()
        );
        immersed.append(!objects_.groups().last().hasWalls());
        places.append(b.centroid());
    };
    for (const entry& e : dict)
    {
        if (userVariables::isAside(dict, e, {"shape", "material"}))
        {
            continue;
        }
        checkShapeEntry(dict, e);
        forShapes(e, domain_.nDims, add);
    }
    space_.reset
    (
        new packing
        (
            domain_.bounds, domain_.spacing, names, surfaces,
            domain_.period, attached, places, immersed
        )
    );
}


bool Foam::fsi::seeding::needsInside(const dictionary& dict) const
{
    const dictionary& material = dict.subDict("material");
    const bool prescribed =
        bodyMotion::New(dict.subOrEmptyDict("motion")).valid()
     && dict.subOrEmptyDict("hold").empty();
    return
        material.lookupOrDefault<word>("type", "") != "rigid"
     && !(domain_.nDims == 3 && prescribed)
     && !sheetMaterial::chosen(material);
}


void Foam::fsi::seeding::addShape
(
    const word& name,
    const dictionary& dict,
    const shape& body
)
{
    const scalar thickness = checkShape(dict, body, domain_);
    const scalar nodeSpacing =
        readPositive(dict, "nodeSpacing", domain_.spacing);
    if (nodeSpacing < 0.65*domain_.spacing)
    {
        WarningInFunction
            << "Nodes of shape " << name << " are " << nodeSpacing
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
                name,
                shapeDict,
                newShapeMesh
                (
                    body,
                    dict.subDict("shape"),
                    domain_.nDims,
                    nodeSpacing,
                    meshGrading(dict.subOrEmptyDict("mesh")),
                    needsInside(dict)
                ),
                nodeSpacing,
                domain_.thickness,
                domain_.nDims,
                body.centroid()
            )
        ),
        dict.subOrEmptyDict("motion")
    );
    if (objects_.groups().last().movesFreely())
    {
        const scalar cells = minimumCells(dict);
        thickness_.append(seedRecord::thickness{name, thickness, cells});
    }
}


void Foam::fsi::seeding::place(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        if (userVariables::isAside(dict, e, {"type", "shape"}))
        {
            continue;
        }
        const dictionary& own = dictOf(dict, e, "placement");
        const label before = space_->size();
        cpuTime clock;
        placement::New(e.keyword(), own, *space_)->place(*space_);
        Info<< "Placed " << e.keyword() << ": " << space_->size() - before
            << " objects in " << clock.cpuTimeIncrement() << " s" << endl;
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
    cpuTime clock;
    addShapes(dict.subDict("shapes"));
    Info<< "Made the shapes in " << clock.cpuTimeIncrement() << " s" << endl;
    place(dict.subDict("placements"));
    clock.cpuTimeIncrement();
    checkVelocities(dict.subDict("placements"));
    checkContacts();
    Info<< "Checked their distances in " << clock.cpuTimeIncrement() << " s"
        << endl;
    populate();
}


// ************************************************************************* //
