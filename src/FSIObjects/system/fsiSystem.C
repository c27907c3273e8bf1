// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiSystem.H"
#include "dictionaryCheck.H"
#include "objectContact.H"
#include "openfoamMesh.H"
#include "readBetween.H"
#include "seedRecord.H"
#include "stateChecks.H"
#include "stockInput.H"
#include "timeFolders.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The mesh, its time with the name of the folder that is read
static const fvMesh& named(const fvMesh& mesh)
{
    nameByFolder(const_cast<Time&>(mesh.time()));
    return mesh;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fsiSystem::fsiSystem
(
    const fvMesh& mesh,
    const dictionary& dict,
    const scalar viscosity
)
:
    log
    (
        std::make_unique<runLog>
        (
            mesh.time(),
            dict.subOrEmptyDict("output")
        )
    ),
    properties(dict),
    grid(named(mesh)),
    sides(mesh),
    objects(mesh.time()),
    wall(wallTreatment::New(dict)),
    levelSet(levelSetUpdate::New(grid, dict)),
    geometry(grid, *wall),
    walls(geometry),
    fluid(geometry),
    driving(drivingForce::New(mesh, dict)),
    fluidDensity(readPositive(dict, "fluidDensity")),
    viscosity(viscosity),
    shortWaveStress(readNonNegative(dict, "shortWaveStress", 1)),
    gravity(stockInput::gravity(mesh, dict)),
    images_(sides.images()),
    surfaces_(&objects.surfaces())
{
    if (objects.nDims() != grid.nDims())
    {
        FatalErrorInFunction
            << "The objects have " << label(objects.nDims())
            << " dimensions but the mesh has " << label(grid.nDims())
            << "; run seedObjects on this mesh"
            << exit(FatalError);
    }
    stateChecks::checkMesh(objects, grid.bounds(), grid.thickness());
    stockInput::checkFrame(mesh);
    const word scheme(ddtSchemeOf(mesh, "ddt(U)"));
    if (scheme == "steadyState")
    {
        FatalIOErrorInFunction(schemesOf(mesh))
            << "Entry 'ddt(U)' or 'default' of ddtSchemes is steadyState, but"
            << " objects move in time: take Euler or backward"
            << exit(FatalIOError);
    }
    renew();
    seedRecord::check(objects, mesh.time(), sides, grid.spacing());
    contacts = std::make_unique<objectContact>(*this);
}


Foam::fsi::fsiSystem::~fsiSystem() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fsiSystem::updateSurfaces()
{
    if (images_.cyclic())
    {
        objects.wrap(images_);
    }
    objects.updateSurfaces();

    // Samples lie up to one cell outside the domain
    const scalar reach = levelSet->bandWidth() + grid.spacing();
    surfaces_ = &images_.update(objects.surfaces(), reach);
}


void Foam::fsi::fsiSystem::updateGeometry()
{
    geometry.update(*levelSet, surfaces());
    walls.update(objects.surfaces());
}


void Foam::fsi::fsiSystem::renew()
{
    updateSurfaces();
    levelSet->initialise(surfaces());
    updateGeometry();
}


void Foam::fsi::fsiSystem::addBodyForce(groupNodal& force) const
{
    forAll(objects.groups(), groupi)
    {
        const shapeTemplate& shape = objects.shape(groupi);
        const vector a
        (
            bodyAcceleration(groupi, gravity, driving->acceleration())
        );
        Eigen::MatrixXd& f = force[groupi];

        for (Eigen::Index column = 0; column < f.cols(); ++column)
        {
            const scalar ai = a[direction(column % grid.nDims())];
            for (Eigen::Index nodei = 0; nodei < f.rows(); ++nodei)
            {
                f(nodei, column) += shape.nodeMasses()[nodei]*ai;
            }
        }
    }
}


void Foam::fsi::fsiSystem::addOutsidePressure
(
    const volScalarField& p,
    groupNodal& force
)
{
    if (!sides.anyOpen())
    {
        return;
    }
    vectorField nodal;
    walls.setOutside(p, nodal);
    nodal *= fluidDensity;
    groupNodal outside;
    objects.layout().toGroups(nodal, outside);
    forAll(force, groupi)
    {
        force[groupi] += outside[groupi];
    }
}


void Foam::fsi::fsiSystem::setGivenFlux
(
    const volScalarField& p,
    const volVectorField& U,
    const vectorField& v
)
{
    if (!sides.anyOpen())
    {
        return;
    }
    boolList isFree(objects.size());
    forAll(isFree, objecti)
    {
        isFree[objecti] = objects.movesFreely(objecti);
    }
    walls.setGivenFlux(p, U, isFree, v);
}


// ************************************************************************* //
