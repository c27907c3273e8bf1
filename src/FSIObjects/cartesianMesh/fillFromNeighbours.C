// SPDX-License-Identifier: GPL-3.0-or-later

#include "fillFromNeighbours.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Compute the weighted mean of a cell's known neighbours; return false if
//  there is none. coupledKnown, coupledValues: known and values of the cells
//  across coupled faces, from the first boundary face.
bool meanOfKnown
(
    const polyMesh& mesh,
    const scalarField* weight,
    const label celli,
    const scalarField& known,
    const scalarList& coupledKnown,
    const scalarField& values,
    const scalarList& coupledValues,
    scalar& mean
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    scalar total = 0, sum = 0;
    for (const label facei : mesh.cells()[celli])
    {
        const label outside = facei - mesh.nInternalFaces();
        const scalar w = weight ? (*weight)[facei] : 1;
        if (outside < 0)
        {
            const label own = mesh.faceOwner()[facei];
            const label other =
                own == celli ? mesh.faceNeighbour()[facei] : own;
            total += w*known[other];
            sum += w*known[other]*values[other];
        }
        else if (patches[fsi::patchOfFaces(patches)[outside]].coupled())
        {
            total += w*coupledKnown[outside];
            sum += w*coupledKnown[outside]*coupledValues[outside];
        }
    }
    mean = sum/max(total, VSMALL);
    return total > 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::fillFromNeighbours
(
    const polyMesh& mesh,
    const scalarField* weight,
    DynamicList<label>& cells,
    scalarField& known,
    scalarField& values
)
{
    scalarList coupledKnown, coupledValues;
    swapCoupledCells(mesh, known, coupledKnown);
    swapCoupledCells(mesh, values, coupledValues);

    DynamicList<label> filled, left;
    DynamicList<scalar> means;
    for (const label celli : cells)
    {
        scalar mean;
        if
        (
            meanOfKnown
            (
                mesh, weight, celli,
                known, coupledKnown, values, coupledValues, mean
            )
        )
        {
            filled.append(celli);
            means.append(mean);
        }
        else
        {
            left.append(celli);
        }
    }
    forAll(filled, i)
    {
        values[filled[i]] = means[i];
        known[filled[i]] = 1;
    }
    cells.transfer(left);
    return overRanks(cells.size(), sumOp<label>());
}


// ************************************************************************* //
