// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "dictionaryCheck.H"
#include "levelSetUpdate.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::fsi::immersedFluid::history>
Foam::fsi::immersedFluid::historyNames
({
    {history::fading, "fading"},
    {history::limited, "limited"},
    {history::full, "full"},
    {history::none, "none"}
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedFluid::immersedFluid
(
    const interfaceGeometry& geometry,
    const dictionary& dict
)
:
    geometry_(geometry),
    faces_(geometry),
    faceHistory_
    (
        IOobject
        (
            "faceHistory",
            geometry.grid().mesh().time().timeName(),
            geometry.grid().mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        geometry.grid().mesh(),
        dimensionedScalar(dimVelocity, Zero)
    ),
    history_
    (
        historyNames
        [
            readChoice(dict, "faceHistory", "fading", historyNames.names())
        ]
    ),
    wholeFace_
    (
        readChoice(dict, "convection", "wholeFace", {"wholeFace", "openPart"})
     == "wholeFace"
    )
{
    // Files of earlier versions do not say so
    faceHistory_.setOriented();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::immersedFluid::setSolidVelocity
(
    volVectorField& U,
    const surfaceSet& surfaces,
    const levelSetUpdate& levelSet
) const
{
    const vectorField& C = U.mesh().C();
    const boolList& fluid = geometry_.fluidCell();

    // Mean velocity of each object's nodes, for cells far from its surface
    vectorField mean(surfaces.size(), Zero);
    forAll(mean, objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label end = surfaces.pointStart()[objecti + 1];
        mean[objecti] =
            average
            (
                SubField<vector>(surfaces.velocities(), end - start, start)
            );
    }

    FixedList<scalar, 3> weights;
    forAll(fluid, celli)
    {
        if (fluid[celli])
        {
            continue;
        }
        const label here = geometry_.haloIndex()[celli];
        const label facei = levelSet.nearestFace()[here];
        if (facei >= 0)
        {
            surfaces.nearestOnFace(facei, C[celli], weights);
            U[celli] =
                surfaces.interpolate(surfaces.velocities(), facei, weights);
        }
        else if (levelSet.object()[here] >= 0)
        {
            U[celli] = mean[levelSet.object()[here]];
        }
    }
    U.correctBoundaryConditions();
}


Foam::labelList Foam::fsi::immersedFluid::solidCells() const
{
    const boolList& fluid = geometry_.fluidCell();
    DynamicList<label> cells;
    forAll(fluid, celli)
    {
        if (!fluid[celli])
        {
            cells.append(celli);
        }
    }
    return labelList(std::move(cells));
}


void Foam::fsi::immersedFluid::constrain(fvVectorMatrix& UEqn) const
{
    const labelList cells(solidCells());
    UEqn.setValues(cells, vectorField(UEqn.psi().primitiveField(), cells));
}


// ************************************************************************* //
