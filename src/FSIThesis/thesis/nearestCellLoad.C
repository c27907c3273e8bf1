// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearestCellLoad.H"
#include "partialForces.H"
#include "fvcGrad.H"
#include "addToRunTimeSelectionTable.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(nearestCellLoad, 0);
    addToRunTimeSelectionTable(hydrodynamicLoad, nearestCellLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::nearestCellLoad::nearestCellLoad(const fluidStep& step)
:
    hydrodynamicLoad(step)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::nearestCellLoad::nearestFluidCell
(
    const point& p,
    const vector& normal,
    label& steps
) const
{
    // Half cells along the normal; the wall is never further than two cells
    const scalar h = step_.objects().grid().spacing();
    for (steps = 0; steps <= 6; ++steps)
    {
        const label celli =
            step_.objects().grid().findCell(p + (0.5*steps*h)*normal);
        if (celli >= 0 && step_.geometry().fluidCell()[celli])
        {
            return celli;
        }
    }
    steps = labelMax;
    return -1;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::nearestCellLoad::calculate
(
    const volScalarField& p,
    const volVectorField& U,
    const vectorField& wallVelocity,
    vectorField& force
) const
{
    const surfaceSet& surfaces = step_.objects().bodies().surfaces();
    const label nNodes = surfaces.nNodes();
    const scalar density = step_.objects().fluid().density;
    const scalar thickness = step_.objects().grid().thickness();
    const scalar mu = step_.objects().fluid().dynamicViscosity();
    const volTensorField gradU(fvc::grad(U));

    // The nearest fluid cell may be another rank's
    vectorField areas(surfaces.faces().size());
    labelList cells(areas.size());
    labelList steps(areas.size());
    forAll(areas, facei)
    {
        const surfaceFace& f = surfaces.faces()[facei];
        areas[facei] = surfaces.areaNormal(facei)*thickness;
        point centre(Zero);
        for (label i = 0; i < nNodes; ++i)
        {
            centre += surfaces.points()[f[i]]/nNodes;
        }
        const vector normal(areas[facei]/max(mag(areas[facei]), VSMALL));
        cells[facei] = nearestFluidCell(centre, normal, steps[facei]);
    }
    labelList nearest(steps);
    combineOverRanks(nearest, minEqOp<label>());

    partialForces part(wallVelocity.size());
    forAll(areas, facei)
    {
        const label celli = cells[facei];
        if (celli < 0 || steps[facei] != nearest[facei])
        {
            continue;
        }
        const vector& area = areas[facei];
        const vector traction
        (
            mu*((gradU[celli] + gradU[celli].T()) & area)
          - density*p[celli]*area
        );
        for (label i = 0; i < nNodes; ++i)
        {
            part.mine()[surfaces.faces()[facei][i]] += traction/nNodes;
        }
    }
    force = part.collect(step_.objects().bodies().ranks());
}


// ************************************************************************* //
