// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjects.H"
#include "dictionaryCheck.H"
#include "motionCheck.H"
#include "needAllObjects.H"
#include "noTraps.H"
#include "openfoamMesh.H"
#include "openfoamVersion.H"
#include "readBetween.H"
#include "seedRecord.H"
#include "stateChecks.H"
#include "stockInput.H"
#include "sumOverRanks.H"
#include "timeFolders.H"
#include "userVariables.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Read fsiProperties: a number that is too large raises no signal
static IOdictionary readProperties(const fvMesh& mesh)
{
    const noTraps untrapped;
    return IOdictionary
    (
        IOobject
        (
            "fsiProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ
        )
    );
}


//- Check the keys of fsiProperties before anything is read from it, and load
//  its libraries
static const dictionary& checked(const Time& time, const dictionary& dict)
{
    const wordList parts
    ({
        "levelSet", "coupling", "membranes", "contact", "boundaries",
        "drivingForce", "frame", "scalars", "output", "ranks"
    });
    wordList keys
    ({
        "fluidDensity", "gravity", "wall", "minWallDistance",
        "shortWaveStress", "libs"
    });
    keys.append(parts);
    userVariables::checkFileKeys
    (
        dict, keys, {"convection", "faceHistory", "transposedStress"}
    );
    checkSubDicts(dict, parts);
    openLibraries(time, dict);
    return dict;
}


//- The mesh, its time with the name of the folder that is read
static const fvMesh& named(const fvMesh& mesh)
{
    nameByFolder(const_cast<Time&>(mesh.time()));
    return mesh;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fsiObjects::fsiObjects
(
    const fvMesh& mesh,
    const scalar viscosity,
    const bool all
)
:
    mesh_(named(mesh)),
    properties_(readProperties(mesh)),
    log_
    (
        mesh.time(),
        checked(mesh.time(), properties_).subOrEmptyDict("output")
    ),
    grid_(mesh),
    sides_(mesh),
    bodies_(mesh.time(), grid_),
    levelSet_(levelSetUpdate::New(grid_, properties_)),
    images_(sides_.images()),
    surfaces_(&bodies_.surfaces()),
    fluid_
    {
        readPositive(properties_, "fluidDensity"),
        viscosity,
        readNonNegative(properties_, "shortWaveStress", 1)
    },
    gravity_(stockInput::gravity(mesh, properties_)),
    loads_(bodies_),
    driving_(drivingForce::New(mesh, properties_)),
    frame_(mesh.time(), properties_),
    contact_(bodies_, grid_, sides_, properties_, fluid_),
    boundaries_(grid_, sides_, bodies_, properties_)
{
    stateChecks::checkMesh
    (
        bodies_, grid_.nDims(), grid_.bounds(), grid_.thickness()
    );
    stockInput::checkFrame(mesh);
    if
    (
        all || needAllObjects(properties_) || contact_.needsAll()
     || levelSet_->type() != "rebuilt"
    )
    {
        bodies_.holdAll();
    }
    else if (severalRanks())
    {
        // Samples of the level set lie up to a cell and a half outside of
        // cells; in a step surfaces move by less than a cell
        const scalar h = grid_.spacing();
        const scalar band = levelSet_->bandWidth() + 1.5*h;
        bodies_.share(max(band, contact_.reach()) + h);
        contact_.share();
    }
    renew();
    seedRecord::check(bodies_, mesh.time(), sides_, grid_.spacing());
    const motionCheck motion(bodies_, mesh.time());
    motion.check(grid_.bounds().span(), grid_.spacing(), sides_.period());
    motion.checkOverlaps(sides_.period(), contact_.letsOverlap());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fsiObjects::write() const
{
    boundaries_.write();
    driving_->write();
    frame_.write();
}


Foam::scalar Foam::fsi::fsiObjects::courantNo() const
{
    const vectorField& v = bodies_.surfaces().velocities();
    const scalar largest = v.size() ? cmptMax(max(cmptMag(v))) : 0;
    return bodies_.ranks().largest(largest)*deltaT()/grid_.spacing();
}


// ************************************************************************* //
