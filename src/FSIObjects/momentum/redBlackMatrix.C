// SPDX-License-Identifier: GPL-3.0-or-later

#include "openfoamMesh.H"
#include "redBlackMatrix.H"
#include "sumOverRanks.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::redBlackMatrix::setCoefficients(const fvVectorMatrix& equation)
{
    const scalarField& upper = equation.upper();
    const scalarField& lower =
        equation.hasLower() ? equation.lower() : upper;

    // Coefficients of both sides of a face make both parts; on a patch the
    // other one is what it adds to the diagonal. Fixed rows have none
    const labelUList& own = equation.lduAddr().lowerAddr();
    const labelUList& nei = equation.lduAddr().upperAddr();
    const labelUList& ownerSlot = order_.ownerSlot();
    const labelUList& neighbourSlot = order_.neighbourSlot();
    x_ = 0;
    const auto addSums = [&](const label celli, const scalar a, const scalar b)
    {
        scalar* sums = &x_[nDims_*row(celli)];
        sums[0] += 0.5*mag(a + b);
        sums[1] += 0.5*mag(a - b);
    };
    forAll(own, facei)
    {
        const scalar a = upper[facei];
        const scalar b = lower[facei];
        coefficient_[ownerSlot[facei]] = a;
        coefficient_[neighbourSlot[facei]] = b;
        addSums(own[facei], a, b);
        addSums(nei[facei], a, b);
    }
    const labelListList& patchSlot = order_.patchSlot();
    forAll(patchSlot, patchi)
    {
        const labelUList& cells = equation.lduAddr().patchAddr(patchi);
        const vectorField& internal = internalCoeffsOf(equation)[patchi];
        const vectorField& boundary = boundaryCoeffsOf(equation)[patchi];
        forAll(patchSlot[patchi], i)
        {
            const scalar a = -boundary[i].x();
            coefficient_[patchSlot[patchi][i]] = a;
            addSums(cells[i], a, -internal[i].x());
        }
    }
}


void Foam::fsi::redBlackMatrix::setDiagonal(const fvVectorMatrix& equation)
{
    const scalarField& diagonal = equation.diag();
    const vectorField& source = equation.source();
    const labelUList& rowOf = order_.rowOf();
    forAll(rowOf, celli)
    {
        const label place = nDims_*rowOf[celli];
        for (label d = 0; d < nDims_; ++d)
        {
            diagonal_[place + d] = diagonal[celli];
            source_[place + d] = source[celli][d];
        }
    }
    forAll(internalCoeffsOf(equation), patchi)
    {
        const labelUList& cells =
            equation.lduAddr().patchAddr(patchi);
        const vectorField& internal = internalCoeffsOf(equation)[patchi];
        const vectorField& boundary = boundaryCoeffsOf(equation)[patchi];
        const bool coupled = equation.psi().boundaryField()[patchi].coupled();
        forAll(cells, i)
        {
            const label place = nDims_*rowOf[cells[i]];
            for (label d = 0; d < nDims_; ++d)
            {
                diagonal_[place + d] += internal[i][d];
                source_[place + d] += coupled ? 0 : boundary[i][d];
            }
        }
    }
}


void Foam::fsi::redBlackMatrix::setRadii()
{
    radii_ = Zero;
    for (label row = 0; row < nRows(); ++row)
    {
        radii_[0] = max(radii_[0], value(row)[0]/(*diagonal(row)));
        radii_[1] = max(radii_[1], value(row)[1]/(*diagonal(row)));
    }
    combineOverRanks(radii_, maxEqOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::redBlackMatrix::redBlackMatrix(const cartesianMesh& grid)
:
    nDims_(grid.nDims()),
    order_(grid),
    // Slots that no face has stay zero
    coefficient_(order_.nSlots()*order_.nCells(), 0),
    diagonal_(nDims_*order_.nCells()),
    source_(nDims_*order_.nCells()),
    x_(nDims_*order_.nRows(), 0),
    singleCoefficient_(coefficient_.size()),
    singleDiagonal_(diagonal_.size()),
    residual_(source_.size()),
    correction_(x_.size(), 0),
    correctionScale_(1),
    nSweeps_(0),
    firstResidual_(0),
    lastResidual_(0),
    radii_(2, Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::redBlackMatrix::set
(
    const fvVectorMatrix& equation,
    const expectedChange& change
)
{
    setCoefficients(equation);
    setDiagonal(equation);
    setRadii();
    const vectorField& U = equation.psi().primitiveField();
    forAll(U, celli)
    {
        const vector start(U[celli] + change[celli]);
        std::copy_n(&start[0], nDims_, &x_[nDims_*row(celli)]);
    }
    correction_ = 0;
}


void Foam::fsi::redBlackMatrix::addToDiagonal
(
    const label celli,
    const scalar value
)
{
    for (label d = 0; d < nDims_; ++d)
    {
        diagonal_[nDims_*row(celli) + d] += value;
    }
}


void Foam::fsi::redBlackMatrix::get(vectorField& U) const
{
    const labelUList& rowOf = order_.rowOf();
    forAll(rowOf, celli)
    {
        for (label d = 0; d < nDims_; ++d)
        {
            U[celli][d] = x_[nDims_*rowOf[celli] + d];
        }
    }
}


Foam::FixedList<Foam::scalar, 2> Foam::fsi::redBlackMatrix::addTo
(
    const boolList& counts,
    const vectorField& expected,
    const scalar factor,
    vectorField& U
) const
{
    const labelUList& rowOf = order_.rowOf();
    const scalar scale = 1/correctionScale_;
    FixedList<scalar, 2> squares(Zero);
    forAll(rowOf, celli)
    {
        vector& u = U[celli];
        vector beyond(-factor*expected[celli]);
        for (label d = 0; d < nDims_; ++d)
        {
            const label i = nDims_*rowOf[celli] + d;
            const scalar added = x_[i] + scale*correction_[i];
            u[d] += added;
            beyond[d] += added;
        }
        if (counts[celli])
        {
            squares[0] += magSqr(beyond);
            squares[1] += magSqr(u);
        }
    }
    return squares;
}


// ************************************************************************* //
