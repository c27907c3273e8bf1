// SPDX-License-Identifier: GPL-3.0-or-later

#include "carriedScalar.H"
#include "fsiObjects.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::carriedScalar::countBodies(const scalar perStep)
{
    const scalarField last(inBodies_);
    const scalar whole = objects_.grid().cellVolume();
    inBodies_ = Zero;
    forAll(open_, celli)
    {
        const scalar K = surfaces_.partition(celli);
        if (K > 0)
        {
            inBodies_[surfaces_.group()[celli]] +=
                K*(whole - open_[celli])*C_[celli];
        }
    }
    forAll(last, groupi)
    {
        fromSurfaces_[groupi] += perStep*(last[groupi] - inBodies_[groupi]);
    }
}


Foam::scalar Foam::fsi::carriedScalar::inflow
(
    const fvScalarMatrix& equation
) const
{
    scalar sum = 0;
    forAll(C_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pC = C_.boundaryField()[patchi];
        const labelUList& cells = pC.patch().faceCells();
        for (label i = 0; i < pC.size() && !pC.coupled(); ++i)
        {
            sum +=
                boundaryCoeffsOf(equation)[patchi][i]
              - internalCoeffsOf(equation)[patchi][i]*C_[cells[i]];
        }
    }
    return sum;
}


void Foam::fsi::carriedScalar::spread(const fvScalarMatrix& equation)
{
    // Sum of the residuals of all cells that are not fixed, which have no
    // coefficients of fixed ones; their volume
    const boolList& fixed = surfaces_.fixed();
    scalarList sums({0, 0, 0});
    forAll(fixed, celli)
    {
        if (!fixed[celli])
        {
            sums[2] += mag(equation.source()[celli]);
            sums[0] +=
                equation.source()[celli] - equation.diag()[celli]*C_[celli];
            sums[1] += volumes_.now()[celli];
        }
    }
    const labelUList& own = C_.mesh().owner();
    const labelUList& nei = C_.mesh().neighbour();
    forAll(own, facei)
    {
        sums[0] -=
            equation.upper()[facei]*C_[nei[facei]]
          + equation.lower()[facei]*C_[own[facei]];
    }
    forAll(C_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pC = C_.boundaryField()[patchi];
        const scalarField& ofOther = boundaryCoeffsOf(equation)[patchi];
        const scalarField& ofCell = internalCoeffsOf(equation)[patchi];
        scalarField across(pC.size(), scalar(1));
        if (pC.coupled())
        {
            across = pC.patchNeighbourField();
        }
        sums[0] += sum(ofOther*across - ofCell*pC.patchInternalField());
    }
    sumOverRanks(sums);
    if (mag(sums[0]) <= 10*SMALL*sums[2])
    {
        // The sum's own round-off
        return;
    }
    const scalar shift = objects_.deltaT()*sums[0]/max(sums[1], VSMALL);
    forAll(fixed, celli)
    {
        C_[celli] += fixed[celli] ? 0 : shift;
    }
}


void Foam::fsi::carriedScalar::write(const scalar inflow)
{
    scalar least = GREAT;
    scalar largest = -GREAT;
    DynamicList<scalar> sums;
    sums.append(-sum(inBodies_));
    sums.append(inflow);
    sums.append(fromSurfaces_);
    forAll(inBodies_, groupi)
    {
        if (surfaces_.all()[groupi].type == scalarSurfaces::permeable)
        {
            sums.append(inBodies_[groupi]);
        }
    }
    forAll(C_, celli)
    {
        if (!surfaces_.fixed()[celli])
        {
            sums[0] += volumes_.now()[celli]*C_[celli];
        }
        if (geometry_.fluidCell()[celli])
        {
            least = min(least, C_[celli]);
            largest = max(largest, C_[celli]);
        }
    }
    sumOverRanks(sums);
    least = overRanks(least, minOp<scalar>());
    largest = overRanks(largest, maxOp<scalar>());
    if (table_.valid())
    {
        csvTable::rowWriter row(table_());
        row << C_.mesh().time().value() << sums[0] << least << largest;
        for (label i = 1; i < sums.size(); ++i)
        {
            row << sums[i];
        }
    }
}


// ************************************************************************* //
