// SPDX-License-Identifier: GPL-3.0-or-later

#include "stockInput.H"
#include "dimensionSet.H"
#include "errorOf.H"
#include "fvMesh.H"
#include "IFstream.H"
#include "misspelling.H"
#include "noTraps.H"
#include "openfoamMesh.H"
#include "readBetween.H"
#include "stepControls.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace stockInput
{

//- A file of the folder constant, whatever its class; empty if there is none
static dictionary constantFile(const fvMesh& mesh, const word& name)
{
    const fileName file(mesh.time().globalPath()/"constant"/name);
    dictionary dict(file);
    if (isFile(file))
    {
        const noTraps untrapped;
        IFstream is(file);
        dict.read(is);
    }
    return dict;
}


//- FatalIOError for the entry of a dictionary
static void refuse
(
    const dictionary& dict,
    const word& key,
    const string& value,
    const char* advice
)
{
    FatalIOErrorInFunction(dict)
        << "Entry '" << key << "' in dictionary " << dict.name() << " is "
        << value.c_str() << ": " << advice << exit(FatalIOError);
}


//- FatalIOError if an entry is there and is none of the words
static void refuseOthers
(
    const dictionary& dict,
    const word& key,
    const wordList& valid,
    const char* advice
)
{
    const word value(readEntryOr<word>(dict, key, valid[0]));
    if (!isIn(valid, value))
    {
        refuse(dict, key, value, advice);
    }
}


static void checkViscosity(const fvMesh& mesh)
{
    const dictionary dict(constantFile(mesh, viscosityDictName()));
    for (const char* key : {"transportModel", "viscosityModel"})
    {
        refuseOthers
        (
            dict, key, {"Newtonian", "constant"},
            "this solver is made for Newtonian fluids"
        );
    }
}


static void checkLaminar(const fvMesh& mesh)
{
    for (const char* name : {"turbulenceProperties", "momentumTransport"})
    {
        const dictionary dict(constantFile(mesh, name));
        refuseOthers
        (
            dict, "simulationType", {"laminar"},
            "this solver has no model of turbulence; take laminar"
        );
        const dictionary laminar(dict.subOrEmptyDict("laminar"));
        for (const char* key : {"laminarModel", "model"})
        {
            refuseOthers
            (
                laminar, key, {"Stokes"},
                "this solver is made for Newtonian fluids"
            );
        }
    }
}


//- The factors of fvSolution that would change p or U
static void checkRelaxation(const dictionary& factors)
{
    for (const word name : {"p", "pFinal", "U", "UFinal"})
    {
        if (factors.found(name) && !factors.isDict(name))
        {
            const scalar factor = readEntry<scalar>(factors, name);
            if (factor != 1)
            {
                refuse
                (
                    factors, name, Foam::name(factor),
                    "a step in time is not relaxed; take 1"
                );
            }
        }
    }
}


//- Print what has no meaning
static void checkStepControls(const dictionary& controls)
{
    const wordList levels({"pRefCell", "pRefPoint", "pRefValue"});
    string unused;
    for (const entry& e : controls)
    {
        const word key(e.keyword());
        const word level(meant(key, levels));
        if (!e.keyword().isPattern() && !level.empty() && level != key)
        {
            FatalIOErrorInFunction(controls)
                << "Unknown entry '" << key << "' in dictionary "
                << controls.name() << ": is " << level << " meant?"
                << exit(FatalIOError);
        }
        for
        (
            const word name :
            {
                "consistent", "momentumPredictor", "nCorrectors",
                "nOuterCorrectors", "residualControl"
            }
        )
        {
            if (key == name)
            {
                unused += ' ' + key;
            }
        }
    }
    if (controls.lookupOrDefault<Switch>("frozenFlow", false))
    {
        refuse(controls, "frozenFlow", "yes", "objects need a flow");
    }
    if (unused.size())
    {
        Info<< "Entries of " << controls.dictName() << " in fvSolution that"
            << " have no meaning here:" << unused.c_str()
            << " (entry coupling gives the passes of a step)" << nl << endl;
    }
}


//- Warn of limiters, which gradients between neighbours do without
static void checkGradients(const dictionary& schemes)
{
    for (const word key : {"default", "grad(p)", "grad(U)"})
    {
        if (schemes.found(key))
        {
            const token scheme(schemes.lookup(key));
            const string name(scheme.isWord() ? scheme.wordToken() : word());
            if (name.find("imited") != string::npos)
            {
                IOWarningInFunction(schemes)
                    << "Entry '" << key << "' in dictionary " << schemes.name()
                    << " is " << name.c_str() << ": gradients are not limited"
                    << " here" << nl << endl;
            }
        }
    }
}

} // End namespace stockInput
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::stockInput::gravity
(
    const fvMesh& mesh,
    const dictionary& fsiProperties
)
{
    const vector given(readFinite(fsiProperties, "gravity", Zero));
    const dictionary file(constantFile(mesh, "g"));
    const bool inFile = file.found("value");
    const vector g(readFinite(file, "value", given));
    if (g != given && fsiProperties.found("gravity"))
    {
        FatalIOErrorInFunction(fsiProperties)
            << "Entry 'gravity' in dictionary " << fsiProperties.name()
            << " is " << given << " but entry 'value' in " << file.name()
            << " is " << g << ": remove one of them" << exit(FatalIOError);
    }
    if (inFile && file.found("dimensions"))
    {
        if (dimensionSet(file.lookup("dimensions")) != dimAcceleration)
        {
            refuse(file, "dimensions", "wrong", "take [0 1 -2 0 0 0 0]");
        }
    }
    if (mesh.nSolutionD() == 2 && g.z() != 0)
    {
        FatalIOErrorInFunction(inFile ? file : fsiProperties)
            << "Entry '" << (inFile ? "value" : "gravity") << "' in dictionary "
            << (inFile ? file : fsiProperties).name() << " is " << g
            << " but a mesh in x and y does not feel its part in z"
            << exit(FatalIOError);
    }
    return g;
}


void Foam::fsi::stockInput::checkFrame(const fvMesh& mesh)
{
    if (ddtSchemeOf(mesh, "ddt(U)") == "steadyState")
    {
        FatalIOErrorInFunction(schemesOf(mesh))
            << "Entry 'ddt(U)' or 'default' of ddtSchemes is steadyState, but"
            << " objects move in time: take Euler or backward"
            << exit(FatalIOError);
    }
    const dictionary zones(constantFile(mesh, "MRFProperties"));
    for (const entry& e : zones)
    {
        if
        (
            e.isDict() && e.keyword() != "FoamFile"
         && e.dict().lookupOrDefault<Switch>("active", true)
        )
        {
            refuse(zones, e.keyword(), "a zone", "objects know no such frame");
        }
    }
    const dictionary frame(constantFile(mesh, "SRFProperties"));
    if (frame.found("SRFModel"))
    {
        refuse
        (
            frame, "SRFModel", "there", "objects know no frame that turns"
        );
    }

    const dictionary motion(constantFile(mesh, "dynamicMeshDict"));
    const char* const advice = "objects need a mesh that stays as it is";
    refuseOthers(motion, "dynamicFvMesh", {"staticFvMesh"}, advice);
    for (const char* key : {"mover", "topoChanger", "distributor"})
    {
        if (motion.found(key))
        {
            refuse(motion, key, "there", advice);
        }
    }
}


void Foam::fsi::stockInput::checkFluid(const fvMesh& mesh, const bool hasLaw)
{
    if (!hasLaw)
    {
        checkViscosity(mesh);
    }
    checkLaminar(mesh);
    const dictionary factors
    (
        solutionControls(mesh).subOrEmptyDict("relaxationFactors")
    );
    checkRelaxation(factors);
    checkRelaxation(factors.subOrEmptyDict("fields"));
    checkRelaxation(factors.subOrEmptyDict("equations"));
    checkStepControls(stepControls(mesh));
    checkGradients(schemesOf(mesh).subOrEmptyDict("gradSchemes"));
}


// ************************************************************************* //
