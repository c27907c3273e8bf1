// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneContact.H"
#include "dictionaryCheck.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Gap below which forces act [m]
static scalar readRange(const fsiObjects& objects, const dictionary& dict)
{
    checkKeys(dict, {"range", "law"});
    checkSubDicts(dict, {"law"});
    const scalar h = objects.grid().spacing();
    return readScalarBetween(dict, "range", 2, 0.01, 20)*h;
}


//- Dictionary of the search
static dictionary searchEntries()
{
    dictionary dict;
    dict.add("selfContact", false);
    return dict;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneContact::membraneContact
(
    const fsiObjects& objects,
    const dictionary& dict
)
:
    objects_(objects),
    range_(readRange(objects, dict)),
    law_
    (
        contactLaw::New
        (
            dict.subDict("law"),
            {objects.grid().spacing(), range_, 1e-40}
        )
    ),
    images_(objects.images()),
    finder_(searchEntries(), images_),
    surfaces_(objects.bodies().nDims())
{
    if (!isA<potentialContact>(law_()))
    {
        FatalIOErrorInFunction(dict)
            << "Law '" << law_->type() << "' in dictionary " << dict.name()
            << " is not for membranes; valid ones are elastic and Morse"
            << exit(FatalIOError);
    }
    if (range_ > objects.contact().reach())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'range' in dictionary " << dict.name() << " is "
            << range_/objects.grid().spacing() << " cells, but must be "
            << objects.contact().reach()/objects.grid().spacing()
            << " at most: range and margin of the dictionary 'contact'"
            << exit(FatalIOError);
    }
    const PtrList<bodyGroup>& groups = objects.bodies().groups();
    areas_.setSize(groups.size());
    forAll(groups, groupi)
    {
        const shapeTemplate& shape = groups[groupi].shape();
        if (!groups[groupi].hasWalls())
        {
            areas_[groupi] = contactBodies::nodeAreas
            (
                shape.mesh().points, shape.faces(),
                shape.nDims(), shape.thickness()
            );
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::fsi::potentialContact& Foam::fsi::membraneContact::law() const
{
    return dynamic_cast<const potentialContact&>(law_());
}


void Foam::fsi::membraneContact::find()
{
    surfaces_ = objects_.bodies().surfaces();
    for (label objecti = 0; objecti < surfaces_.size(); ++objecti)
    {
        surfaces_.setImmersed(objecti, surfaces_.hasWalls(objecti));
    }
    contactBodies nodes;
    nodes.reset(surfaces_);
    finder_.find
    (
        surfaces_,
        nodes,
        List<contactWall>(),
        List<medialAxisPoint>(),
        range_,
        found_
    );
}


Foam::scalar Foam::fsi::membraneContact::area(const label nodei) const
{
    const label objecti = surfaces_.pointObject()[nodei];
    const label groupi = objects_.bodies().objectGroup(objecti);
    return areas_[groupi][nodei - surfaces_.pointStart()[objecti]];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneContact::add
(
    const scalar deltaT,
    vectorField& nodal
)
{
    find();
    const scalar perStiffness =
        deltaT
       /(objects_.fluid().dynamicViscosity()*objects_.grid().spacing());
    scalar largest = 0;
    for (const contactPair& pair : found_.pairs)
    {
        // The pairs of other nodes are the business of their owners
        if (surfaces_.pointObject()[pair.node] >= objects_.bodies().size())
        {
            continue;
        }
        const scalar s = area(pair.node);
        const vector f(0.5*s*law().pressure(pair.gap)*pair.normal);
        nodal[pair.node] += f;
        const surfaceFace& face = surfaces_.faces()[pair.face];
        for (label i = 0; i < surfaces_.nNodes(); ++i)
        {
            nodal[face[i]] -= pair.weights[i]*f;
        }
        if (pair.gap < range_)
        {
            const scalar slope = -law().repulsionSlope(pair.gap);
            largest = max(largest, perStiffness*s*slope);
        }
    }
    largest = objects_.bodies().ranks().largest(largest);
    if (largest > stepLimit)
    {
        FatalErrorInFunction
            << "The time step " << deltaT << " s is too long for the forces"
            << " between membranes: dt s |dp/dg|/(mu h) is " << largest
            << " but must be " << stepLimit << " at most" << nl
            << "Take a step of " << deltaT*stepLimit/largest << " s or less"
            << " (less still where they come nearer), a smaller adhesionEnergy"
            << " or a larger width"
            << exit(FatalError);
    }
}


// ************************************************************************* //
