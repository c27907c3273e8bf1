// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "dictionaryCheck.H"
#include "fetchAhead.H"
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
        const label here = geometry_.grid().haloIndex()[celli];
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


void Foam::fsi::immersedFluid::constrain(fvVectorMatrix& UEqn) const
{
    // As setValues does for the solid cells, which goes through each cell's
    // faces, in 2D two empty ones
    const boolList& fluid = geometry_.fluidCell();
    const vectorField& U = UEqn.psi().primitiveField();
    const scalarField& diagonal = UEqn.diag();
    scalarField& upper = UEqn.upper();
    scalarField& lower = UEqn.lower();
    vectorField& source = UEqn.source();
    const UList<wallLink>& links = geometry_.wallLinks();
    forAll(links, i)
    {
        const wallLink& later = fetchedAhead(links, i);
        fetchAhead(source[later.cell]);
        fetchAhead(U[max(later.across, 0)]);
        fetchAhead(upper[min(later.face, upper.size() - 1)]);
        fetchAhead(lower[min(later.face, lower.size() - 1)]);

        const wallLink& link = links[i];
        if (link.across >= 0)
        {
            // The owner is the cell of the lower number
            source[link.cell] -=
                (link.cell < link.across ? upper : lower)[link.face]
               *U[link.across];
            upper[link.face] = lower[link.face] = 0;
        }
    }
    const labelUList& firstFace = UEqn.lduAddr().ownerStartAddr();
    forAll(fluid, celli)
    {
        if (!fluid[celli])
        {
            source[celli] = U[celli]*diagonal[celli];
            for (label i = firstFace[celli]; i < firstFace[celli + 1]; ++i)
            {
                upper[i] = lower[i] = 0;
            }
        }
    }
    forAll(UEqn.internalCoeffs(), patchi)
    {
        const labelUList& cells = UEqn.lduAddr().patchAddr(patchi);
        forAll(UEqn.internalCoeffs()[patchi], i)
        {
            if (!fluid[cells[i]])
            {
                UEqn.internalCoeffs()[patchi][i] = Zero;
                UEqn.boundaryCoeffs()[patchi][i] = Zero;
            }
        }
    }
}


// ************************************************************************* //
