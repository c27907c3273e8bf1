// SPDX-License-Identifier: GPL-3.0-or-later

#include "modelViscosity.H"
#include "calculatedFvPatchFields.H"
#include "emptyPolyPatch.H"
#include "polyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::autoPtr<Foam::fvMesh> Foam::fsi::modelViscosity::newCubes
(
    const fvMesh& mesh
)
{
    const FixedList<face, 6> sides
    ({
        face({0, 1, 5, 4}), face({3, 7, 6, 2}), face({0, 4, 7, 3}),
        face({1, 2, 6, 5}), face({0, 3, 2, 1}), face({4, 5, 6, 7})
    });
    const boundBox cube(point(0, 0, 0), point(1, 1, 1));
    pointField points;
    faceList faces(6*size);
    labelList owner(6*size);
    for (label i = 0; i < size; ++i)
    {
        points.append(cube.points()() + point(2*i, 0, 0));
    }
    const auto setFace = [&](const label facei, const label cubei, face side)
    {
        for (label& pointi : side)
        {
            pointi += 8*cubei;
        }
        faces[facei] = side;
        owner[facei] = cubei;
    };
    for (label i = 0; i < size; ++i)
    {
        for (label s = 0; s < 6; ++s)
        {
            setFace(s < 2 ? 2*i + s : 2*size + 4*i + s - 2, i, sides[s]);
        }
    }
    // With the name of the case's mesh, it reads the case's fvSchemes. Time
    // knows the case's mesh by this name, and not this one
    autoPtr<fvMesh> cubes
    (
        new fvMesh
        (
            IOobject
            (
                mesh.name(), mesh.time().timeName(), mesh.time(),
                IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
            ),
            std::move(points), std::move(faces), std::move(owner), labelList(),
            false
        )
    );
    const polyBoundaryMesh& all = cubes->boundaryMesh();
    List<polyPatch*> patches(2);
    patches[0] = new polyPatch
    (
        "sliding", 2*size, 0, 0, all, polyPatch::typeName
    );
    patches[1] = new emptyPolyPatch
    (
        "others", 4*size, 2*size, 1, all, emptyPolyPatch::typeName
    );
    cubes->addFvPatches(patches, false);
    return cubes;
}


void Foam::fsi::modelViscosity::evaluate
(
    const UList<scalar>& shearRate,
    UList<scalar>& nu
)
{
    fvPatchVectorField& sliding = U_->boundaryFieldRef()[0];
    forAll(shearRate, i)
    {
        sliding[2*i] = vector(-0.5*shearRate[i], 0, 0);
        sliding[2*i + 1] = vector(0.5*shearRate[i], 0, 0);
    }
    model_->correct();
    const tmp<volScalarField> tnu(model_->nu());
    forAll(nu, i)
    {
        nu[i] = tnu()[i];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::modelViscosity::modelViscosity
(
    const dictionary& dict,
    volScalarField& field
)
:
    field_(field),
    cubes_(newCubes(field.mesh()))
{
    const auto io = [&](const word& name)
    {
        return IOobject(name, field.time().timeName(), cubes_());
    };
    U_.reset
    (
        new volVectorField
        (
            io("U"), cubes_(), dimensionedVector(dimVelocity, Zero)
        )
    );
    phi_.reset
    (
        new surfaceScalarField
        (
            io("phi"), cubes_(), dimensionedScalar(dimVelocity*dimArea, Zero)
        )
    );
    model_ = viscosityModel::New("nu", dict, U_(), phi_());
}


// * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * * //

bool Foam::fsi::modelViscosity::isNewtonian(const dictionary& dict)
{
    const word model(dict.lookupOrDefault<word>("transportModel", "Newtonian"));
    wordList known;
    for
    (
        const word& name
      : viscosityModel::dictionaryConstructorTablePtr_->sortedToc()
    )
    {
        // Others need a field of the temperature
        if (name.find("Arrhenius") == std::string::npos)
        {
            known.append(name);
        }
    }
    if (!known.found(model))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'transportModel' in dictionary " << dict.name() << " is "
            << model << " but must be one of " << flatOutput(known)
            << exit(FatalIOError);
    }
    return model == "Newtonian";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::modelViscosity::viscosity
(
    const UList<scalar>& shearRate,
    scalarField& nu
)
{
    nu.setSize(shearRate.size());
    for (label start = 0; start < nu.size(); start += size)
    {
        const label n = min(size, nu.size() - start);
        SubList<scalar> part(nu, n, start);
        evaluate(SubList<scalar>(shearRate, n, start), part);
    }
}


// ************************************************************************* //
