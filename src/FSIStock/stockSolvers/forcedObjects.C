// SPDX-License-Identifier: GPL-3.0-or-later

#include "forcedObjects.H"
#include "bodyGroup.H"
#include "boundBox.H"
#include "dictionaryCheck.H"
#include "dimensionedScalar.H"
#include "IOdictionary.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Name of a field that an entry gives; fatal if there is no such field
template<class Field>
static word stockField
(
    const fvMesh& mesh,
    const dictionary& dict,
    const word& key
)
{
    const word name(dict.lookupOrDefault<word>(key, key));
    if (!mesh.foundObject<Field>(name))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name()
            << " is " << name << " but the fields of this type are "
            << flatOutput(namesIn<Field>(mesh)) << exit(FatalIOError);
    }
    return name;
}


//- The mesh; fatal if its objects belong to the solver or another model
static const fvMesh& withoutObjects
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    if (mesh.foundObject<volScalarField>("signedDistance"))
    {
        FatalIOErrorInFunction(dict)
            << dict.name() << " of type fsiObjects would move the objects"
            << " twice: it is for solvers that know no objects, not for"
            << " fsiPisoFoam or fsiFluid, and only one may be active"
            << exit(FatalIOError);
    }
    return mesh;
}


//- Viscosity of the Newtonian fluid [m2/s]; 0 for other fluids (direct
//  forcing does not need it)
static scalar stockViscosity(const fvMesh& mesh)
{
    const dictionary& properties =
        mesh.lookupObject<IOdictionary>(viscosityDictName());
    return
        properties.found("nu")
      ? dimensionedScalar("nu", sqr(dimLength)/dimTime, properties).value()
      : 0;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::forcedObjects::forcedObjects
(
    const fvMesh& mesh,
    const dictionary& dict,
    const wordList& keys
)
:
    mesh_(withoutObjects(mesh, dict)),
    velocityName_(stockField<volVectorField>(mesh, dict, "U")),
    objects_(mesh, stockViscosity(mesh), true),
    step_
    (
        objects_,
        mesh.lookupObject<volVectorField>(velocityName_),
        objects_.properties().subOrEmptyDict("coupling")
    ),
    timeIndex_(mesh.time().timeIndex()),
    warned_(false),
    shortest_(GREAT)
{
    wordList known(keys);
    known.append("U");
    checkKeys(dict, known);
    step_.announce();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::forcedObjects::checkWaves()
{
    const scalar deltaT = mesh_.time().deltaTValue();
    if (warned_ || deltaT >= shortest_)
    {
        return;
    }
    shortest_ = deltaT;
    for (const bodyGroup& group : objects_.bodies().groups())
    {
        const shapeTemplate& shape = group.shape();
        const scalar modulus = shape.youngsModulus();
        const scalar size = cmptMax(boundBox(shape.points(), false).span());
        const scalar least =
            modulus > 0 ? size*sqrt(shape.density()/modulus) : 0;
        if (!warned_ && deltaT < least)
        {
            warned_ = true;
            objects_.log().warned("step below that of elastic waves");
            WarningInFunction
                << "The step of " << deltaT << " s is shorter than the "
                << least << " s in which an elastic wave crosses shape "
                << shape.name() << ": with direct forcing the run may lose its"
                << " stability." << nl
                << "    Take a larger deltaT (or maxCo), a larger E, or"
                << " fsiPisoFoam or fsiFluid" << nl << endl;
        }
    }
}


void Foam::fsi::forcedObjects::checkStep()
{
    const scalar deltaT = mesh_.time().deltaTValue();
    floor_.read(mesh_.time().controlDict());
    floor_.take(deltaT);
    if (deltaT < floor_.value())
    {
        FatalErrorInFunction
            << "At time " << nameOf(mesh_.time()) << " the time step falls to "
            << deltaT << " s, below " << floor_.value()
            << " s: the run has lost its"
            << " stability. With direct forcing steps may be too small: take a"
            << " larger maxCo, a larger E, or fsiPisoFoam or fsiFluid. If the"
            << " speed is meant, set minDeltaT" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::forcedObjects::advance()
{
    const Time& time = mesh_.time();
    if (timeIndex_ != time.timeIndex())
    {
        timeIndex_ = time.timeIndex();
        checkStep();
        checkWaves();
        step_.advance(flowSources());
        step_.write();
    }
}


void Foam::fsi::forcedObjects::force(fvVectorMatrix& UEqn)
{
    step_.force(UEqn);
}


Foam::scalar Foam::fsi::forcedObjects::maxDeltaT() const
{
    const scalar courantNo = objects_.courantNo();
    const scalar maxCo = readPositive
    (
        mesh_.time().controlDict(), "maxCo", 0.5
    );
    return
        courantNo > 0 ? maxCo*mesh_.time().deltaTValue()/courantNo : GREAT;
}


// ************************************************************************* //
