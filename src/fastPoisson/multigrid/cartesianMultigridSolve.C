// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMultigrid.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::cartesianMultigrid::addSparse
(
    const addedTerm& term,
    const scalarField& p,
    scalarField& Ap
) const
{
    lattice_.transfer().gather(termPlaces_, p, termX_);
    termAx_.setSize(termX_.size());
    termAx_ = Zero;
    term.add(termAx_, termX_);
    scalar dot = 0;
    forAll(termAx_, i)
    {
        termAx_[i] *= matrix_.sign();
        dot += termAx_[i]*termX_[i];
    }
    lattice_.transfer().add(termPlaces_, termAx_, Ap);
    return dot;
}


void Foam::fsi::cartesianMultigrid::addByCells
(
    const addedTerm& term,
    const scalarField& p,
    scalarField& Ap
) const
{
    const cellTransfer& transfer = lattice_.transfer();
    cellX_.setSize(lattice_.map().cells().size());
    cellAx_.setSize(cellX_.size());
    transfer.toCells(p.cdata(), 1, cellX_);
    transfer.toCells(Ap.cdata(), matrix_.sign(), cellAx_);
    term.add(cellAx_, cellX_);
    transfer.toBlock(cellAx_, matrix_.sign(), Ap.data());
}


Foam::scalar Foam::fsi::cartesianMultigrid::multiply
(
    scalarField& p,
    scalarField& Ap,
    const addedTerm* term
) const
{
    matrix_.halo().fill(p.data());
    scalar dot = product(matrix_.A(), p.cdata(), Ap.data());
    if (term && term->cells())
    {
        dot += addSparse(*term, p, Ap);
    }
    else if (term)
    {
        addByCells(*term, p, Ap);
        dot = dotProduct(matrix_.A(), p.cdata(), Ap.cdata());
    }
    return total(dot);
}


Foam::scalar Foam::fsi::cartesianMultigrid::nextDirection
(
    const scalar residual,
    const scalar oldProduct
) const
{
    // Single precision needs values of order one
    const stencil<double>& A = matrix_.A();
    const scalar size =
        max(residual/nMeshCells_, VSMALL);

    multigridLevel& finest = hierarchy_.finest();
    scaled(A, 1/size, r_.cdata(), finest.b().data());
    hierarchy_.cycle();

    const scalar factor = size/norm_;
    const scalar rz =
        total(factor*dotProduct(A, r_.cdata(), finest.x().cdata()));
    const scalar beta = oldProduct > 0 ? rz/oldProduct : 0;
    updateDirection(A, factor, finest.x().cdata(), beta, p_.data());
    return rz;
}


void Foam::fsi::cartesianMultigrid::iterate
(
    solverPerformance& result,
    const scalar factor,
    const loopControls& controls,
    const addedTerm* term
) const
{
    scalar rz = 0;
    do
    {
        rz = nextDirection(factor*result.finalResidual(), rz);
        const scalar pAp = multiply(p_, Ap_, term);
        if (result.checkSingularity(mag(pAp)/factor))
        {
            break;
        }
        const scalar alpha = rz/pAp;
        result.finalResidual() =
            total
            (
                updateSolution
                (
                    matrix_.A(), alpha, p_.cdata(), Ap_.cdata(),
                    x_.data(), r_.data()
                )
            )/factor;
    } while
    (
        (
            ++result.nIterations() < controls.maxIter
         && !result.checkConvergence(controls.tolerance, controls.relTol)
        )
     || result.nIterations() < controls.minIter
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::solverPerformance Foam::fsi::cartesianMultigrid::solve
(
    scalarField& psi,
    const scalarField& source,
    const word& fieldName,
    const loopControls& controls,
    const addedTerm* term
) const
{
    solverPerformance result("cartesianMG", fieldName);
    const cellTransfer& transfer = lattice_.transfer();
    if (term && term->cells())
    {
        termPlaces_ = transfer.places(*term->cells());
    }

    transfer.toBlock(psi, 1, x_.data());
    transfer.toBlock(source, matrix_.sign(), r_.data());
    multiply(x_, Ap_, term);
    const scalar factor =
        matrix_.normFactor(Ap_, r_, total(sum(psi))/nMeshCells_);

    // p_ is set to zero for the first direction
    p_ = 0;
    const scalar residual =
        total
        (
            updateSolution
            (
                matrix_.A(), 1, p_.cdata(), Ap_.cdata(),
                x_.data(), r_.data()
            )
        );
    if (!term || term->keepsLevel())
    {
        // Of the source, and of the rounding errors of A x
        matrix_.removeLevel(r_);
    }
    result.initialResidual() = residual/factor;
    result.finalResidual() = result.initialResidual();

    if
    (
        controls.minIter > 0
     || !result.checkConvergence(controls.tolerance, controls.relTol)
    )
    {
        iterate(result, factor, controls, term);
        transfer.toCells(x_.cdata(), 1, psi);
    }
    return result;
}


// ************************************************************************* //
