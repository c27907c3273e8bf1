// SPDX-License-Identifier: GPL-3.0-or-later

#include "matrixWithTerm.H"
#include "stencilProducts.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::matrixWithTerm::addSparse
(
    const scalarField& p,
    scalarField& Ap
)
{
    const cellTransfer& transfer = matrix_.lattice().transfer();
    transfer.gather(termPlaces_, p, termX_);
    termAx_.setSize(termX_.size());
    termAx_ = Zero;
    term_->add(termAx_, termX_);
    scalar dot = 0;
    forAll(termAx_, i)
    {
        termAx_[i] *= matrix_.sign();
        dot += termAx_[i]*termX_[i];
    }
    transfer.add(termPlaces_, termAx_, Ap);
    return dot;
}


void Foam::fsi::matrixWithTerm::addByCells
(
    const scalarField& p,
    scalarField& Ap
)
{
    const cellTransfer& transfer = matrix_.lattice().transfer();
    cellX_.setSize(matrix_.lattice().map().cells().size());
    cellAx_.setSize(cellX_.size());
    transfer.toCells(p.cdata(), 1, cellX_);
    transfer.toCells(Ap.cdata(), matrix_.sign(), cellAx_);
    term_->add(cellAx_, cellX_);
    transfer.toBlock(cellAx_, matrix_.sign(), Ap.data());
}


Foam::scalar Foam::fsi::matrixWithTerm::withTerm
(
    const scalar dot,
    const scalarField& p,
    scalarField& Ap
)
{
    if (term_ && term_->cells())
    {
        return dot + addSparse(p, Ap);
    }
    if (term_)
    {
        addByCells(p, Ap);
        return dotProduct(matrix_.A(), p.cdata(), Ap.cdata());
    }
    return dot;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::matrixWithTerm::matrixWithTerm(const structuredMatrix& matrix)
:
    matrix_(matrix),
    term_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::matrixWithTerm::set(const addedTerm* term)
{
    term_ = term;
    if (term_ && term_->cells())
    {
        termPlaces_ = matrix_.lattice().transfer().places(*term_->cells());
    }
}


Foam::scalar Foam::fsi::matrixWithTerm::multiply
(
    scalarField& p,
    scalarField& Ap
)
{
    matrix_.halo().fill(p.data());
    return withTerm(product(matrix_.A(), p.cdata(), Ap.data()), p, Ap);
}


Foam::scalar Foam::fsi::matrixWithTerm::multiplyNext
(
    const scalar factor,
    const float* z,
    const scalar beta,
    scalarField& p,
    scalarField& Ap
)
{
    const stencil<double>& A = matrix_.A();
    if (matrix_.lattice().layout().coupled())
    {
        updateDirection(A, factor, z, beta, p.data());
        return multiply(p, Ap);
    }
    const scalar dot =
        directionAndProduct(A, factor, z, beta, p.data(), Ap.data());
    return withTerm(dot, p, Ap);
}


// ************************************************************************* //
