// SPDX-License-Identifier: GPL-3.0-or-later

#include "colouredMatrix.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::colouredMatrix::setRows()
{
    const cartesianBlock block(grid_.cells());
    const labelList& blockIndex = grid_.blockIndex();
    const labelVector& start = block.start();

    boolList red(blockIndex.size());
    nRed_ = 0;
    forAll(red, celli)
    {
        const labelVector ijk(block.ijk(blockIndex[celli]) + start);
        red[celli] = (ijk.x() + ijk.y() + ijk.z()) % 2 == 0;
        nRed_ += red[celli];
    }

    // In the order of the block, so that neighbours are near in memory
    labelList order(block.size(), -1);
    forAll(blockIndex, celli)
    {
        order[blockIndex[celli]] = celli;
    }
    label nextRed = 0;
    label nextBlack = nRed_;
    rowOf_.setSize(red.size());
    for (const label celli : order)
    {
        if (celli >= 0)
        {
            rowOf_[celli] = red[celli] ? nextRed++ : nextBlack++;
        }
    }
}


Foam::label Foam::fsi::colouredMatrix::nextSlot
(
    labelList& neighbourRow,
    const label celli,
    const label row
) const
{
    label slot = nSlots_*rowOf_[celli];
    while (neighbourRow[slot] >= 0)
    {
        ++slot;
    }
    neighbourRow[slot] = row;
    return slot;
}


Foam::labelList Foam::fsi::colouredMatrix::setSlots()
{
    const fvMesh& mesh = grid_.mesh();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    const label nCells = mesh.nCells();

    labelList neighbourRow(nSlots_*nCells, -1);
    ownerSlot_.setSize(own.size());
    neighbourSlot_.setSize(own.size());
    forAll(own, facei)
    {
        ownerSlot_[facei] =
            nextSlot(neighbourRow, own[facei], rowOf_[nei[facei]]);
        neighbourSlot_[facei] =
            nextSlot(neighbourRow, nei[facei], rowOf_[own[facei]]);
    }

    label nRows = nCells;
    patchSlot_.setSize(mesh.boundary().size());
    ghostStart_.setSize(mesh.boundary().size(), -1);
    forAll(patchSlot_, patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const labelUList& cells = patch.faceCells();
        patchSlot_[patchi].setSize(cells.size());
        const bool ghosts = isA<processorPolyPatch>(patch);
        if (ghosts)
        {
            ghostStart_[patchi] = nRows;
            nRows += cells.size();
        }
        forAll(cells, i)
        {
            const label row =
                ghosts
              ? ghostStart_[patchi] + i
              : rowOf_
                [
                    refCast<const cyclicPolyPatch>(patch)
                   .neighbPatch().faceCells()[i]
                ];
            patchSlot_[patchi][i] = nextSlot(neighbourRow, cells[i], row);
        }
    }

    setSizes(nRows);
    return neighbourRow;
}


void Foam::fsi::colouredMatrix::setSizes(const label nRows)
{
    // Slots that no face has stay zero
    const label nCells = rowOf_.size();
    coefficient_.setSize(nSlots_*nCells, 0);
    symmetric_.setSize(nCells);
    antisymmetric_.setSize(nCells);
    diagonal_.setSize(nDims_*nCells);
    source_.setSize(nDims_*nCells);
    x_.setSize(nDims_*nRows, 0);
    singleCoefficient_.setSize(coefficient_.size());
    singleDiagonal_.setSize(diagonal_.size());
    residual_.setSize(source_.size());
    correction_.setSize(x_.size(), 0);
}


void Foam::fsi::colouredMatrix::setCoefficients(const fvVectorMatrix& equation)
{
    const bool symmetric = !equation.hasLower();
    const scalarField& upper = equation.upper();
    const scalarField& lower = symmetric ? upper : equation.lower();

    // A coefficient and the one of the other side of its face make the
    // symmetric and the antisymmetric part. Rows with fixed values have none
    const labelUList& own = grid_.mesh().owner();
    const labelUList& nei = grid_.mesh().neighbour();
    symmetric_ = 0;
    antisymmetric_ = 0;
    forAll(ownerSlot_, facei)
    {
        const scalar a = upper[facei];
        const scalar b = lower[facei];
        coefficient_[ownerSlot_[facei]] = a;
        coefficient_[neighbourSlot_[facei]] = b;
        for (const label celli : {own[facei], nei[facei]})
        {
            symmetric_[celli] += 0.5*mag(a + b);
            antisymmetric_[celli] += 0.5*mag(a - b);
        }
    }
    forAll(patchSlot_, patchi)
    {
        const vectorField& coeffs = equation.boundaryCoeffs()[patchi];
        forAll(patchSlot_[patchi], i)
        {
            coefficient_[patchSlot_[patchi][i]] = -coeffs[i].x();
        }
    }
}


void Foam::fsi::colouredMatrix::setDiagonal(const fvVectorMatrix& equation)
{
    const scalarField& diagonal = equation.diag();
    const vectorField& source = equation.source();
    const vectorField& U = equation.psi().primitiveField();
    forAll(rowOf_, celli)
    {
        const label place = nDims_*rowOf_[celli];
        for (label d = 0; d < nDims_; ++d)
        {
            diagonal_[place + d] = diagonal[celli];
            source_[place + d] = source[celli][d];
            x_[place + d] = U[celli][d];
        }
    }
    forAll(patchSlot_, patchi)
    {
        const labelUList& cells =
            equation.lduAddr().patchAddr(patchi);
        const vectorField& internal = equation.internalCoeffs()[patchi];
        const vectorField& boundary = equation.boundaryCoeffs()[patchi];
        const bool coupled = equation.psi().boundaryField()[patchi].coupled();
        forAll(cells, i)
        {
            const label place = nDims_*rowOf_[cells[i]];
            for (label d = 0; d < nDims_; ++d)
            {
                diagonal_[place + d] += internal[i][d];
                source_[place + d] += coupled ? 0 : boundary[i][d];
            }
        }
    }
}


void Foam::fsi::colouredMatrix::setRelaxation()
{
    scalar alpha = 0;
    scalar beta = 0;
    forAll(rowOf_, celli)
    {
        const scalar d = diagonal_[nDims_*rowOf_[celli]];
        alpha = max(alpha, symmetric_[celli]/d);
        beta = max(beta, antisymmetric_[celli]/d);
    }
    reduce(alpha, maxOp<scalar>());
    reduce(beta, maxOp<scalar>());
    jacobiRadius_ = alpha;
    relaxation_ = 2/(1 + Foam::sqrt(max(1 - sqr(alpha), 0.0) + sqr(beta)));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::colouredMatrix::colouredMatrix(const cartesianMesh& grid)
:
    grid_(grid),
    nDims_(grid.nDims()),
    nSlots_(2*grid.nDims()),
    nRed_(0),
    nRedRuns_(0),
    correctionScale_(1),
    nSweeps_(0),
    firstResidual_(0),
    lastResidual_(0),
    relaxation_(1),
    jacobiRadius_(0)
{
    setRows();
    setRuns(setSlots());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::colouredMatrix::set(const fvVectorMatrix& equation)
{
    setCoefficients(equation);
    setDiagonal(equation);
    setRelaxation();
    correction_ = 0;
}


void Foam::fsi::colouredMatrix::addToDiagonal
(
    const label celli,
    const scalar value
)
{
    for (label d = 0; d < nDims_; ++d)
    {
        diagonal_[nDims_*rowOf_[celli] + d] += value;
    }
}


void Foam::fsi::colouredMatrix::get(vectorField& U) const
{
    forAll(rowOf_, celli)
    {
        for (label d = 0; d < nDims_; ++d)
        {
            U[celli][d] = x_[nDims_*rowOf_[celli] + d];
        }
    }
}


void Foam::fsi::colouredMatrix::addTo(vectorField& U) const
{
    const scalar scale = 1/correctionScale_;
    forAll(rowOf_, celli)
    {
        for (label d = 0; d < nDims_; ++d)
        {
            const label i = nDims_*rowOf_[celli] + d;
            U[celli][d] += x_[i] + scale*correction_[i];
        }
    }
}


// ************************************************************************* //
