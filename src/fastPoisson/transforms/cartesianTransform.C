// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianTransform.H"
#include "latticeRanks.H"
#include "stencilProducts.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::cartesianTransform::total(scalar value) const
{
    reduceOverRanks(value, sumOp<scalar>(), lattice_.comm());
    return value;
}


void Foam::fsi::cartesianTransform::correct(scalarField& psi) const
{
    // The reference cell's row is that of the others with e x_ref added: the
    // sum of all rows is e x_ref if the rest is singular
    const label place = coefficients_->referencePlace();
    const scalar excess = coefficients_->referenceExcess();
    const bool shifts = coefficients_->singular() && excess > 0;
    scalar reference = 0;
    if (shifts)
    {
        lattice_.transfer().toCells(r_.cdata(), 1, cellR_);
        reference = total(sum(cellR_))/excess;
        if (place >= 0)
        {
            r_[place] -= excess*reference;
        }
    }
    lattice_.transfer().toCells(r_.cdata(), 1, cellR_);
    inverse_.apply(cellR_, cellZ_);

    if (shifts)
    {
        lattice_.transfer().toBlock(cellZ_, 1, Ax_.data());
        cellZ_ += reference - total(place >= 0 ? Ax_[place] : 0);
    }
    psi += cellZ_;
}


Foam::scalar Foam::fsi::cartesianTransform::residual
(
    const scalarField& psi,
    const scalarField& source
) const
{
    lattice_.transfer().toBlock(psi, 1, x_.data());
    lattice_.transfer().toBlock(source, matrix_.sign(), r_.data());
    matrix_.halo().fill(x_.data());
    product(matrix_.A(), x_.cdata(), Ax_.data());

    scalar sum = 0;
    forAll(r_, place)
    {
        r_[place] -= Ax_[place];
        sum += mag(r_[place]);
    }
    return total(sum);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianTransform::cartesianTransform(const polyMesh& mesh)
:
    lattice_(cartesianLattice::New(mesh)),
    matrix_(lattice_),
    inverse_(lattice_),
    cellR_(mesh.nCells()),
    cellZ_(mesh.nCells())
{
    const scalar nCells = total(scalar(mesh.nCells()));
    if (label(std::lround(nCells)) != lattice_.partition().nCells())
    {
        FatalErrorInFunction
            << "cartesianFFT needs a box of cells without holes and steps; "
            << "use cartesianMG or GAMG for this mesh." << exit(FatalError);
    }

    for (scalarField* field : {&x_, &r_, &Ax_})
    {
        field->setSize(lattice_.layout().size(), 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cartesianTransform::update
(
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const lduInterfaceFieldPtrsList& interfaces,
    const bool exact
)
{
    matrix_.update(matrix, interfaceBouCoeffs, interfaces);
    coefficients_.reset(new constantCoefficients(matrix_));
    const constantCoefficients& found = *coefficients_;
    if (exact && !found.reason().empty())
    {
        FatalErrorInFunction
            << "cartesianFFT solves equations with constant coefficients "
            << "only, but " << found.reason() << '.' << nl
            << "    Use 'solver cartesianMG;', or"
            << " 'solver PCG; preconditioner cartesianFFT;', or GAMG."
            << exit(FatalError);
    }

    inverse_.set(found.kinds(), found.face(), found.diagonal());
}


void Foam::fsi::cartesianTransform::precondition
(
    scalarField& z,
    const scalarField& r
) const
{
    cellR_ = matrix_.sign()*r;
    inverse_.apply(cellR_, z);
}


Foam::solverPerformance Foam::fsi::cartesianTransform::solve
(
    scalarField& psi,
    const scalarField& source,
    const word& fieldName,
    const scalar tolerance,
    const scalar relTol,
    const label minIter,
    const label maxIter
) const
{
    solverPerformance result("cartesianFFT", fieldName);
    scalar left = residual(psi, source);

    // The source in this rank's box, for the normalisation
    lattice_.transfer().toBlock(source, matrix_.sign(), x_.data());
    const scalar nCells = lattice_.partition().nCells();
    const scalar factor =
        matrix_.normFactor(Ax_, x_, total(sum(psi))/nCells);
    result.initialResidual() = left/factor;
    result.finalResidual() = result.initialResidual();

    while
    (
        result.nIterations() < minIter
     || (
            result.nIterations() < maxIter
         && !result.checkConvergence(tolerance, relTol)
        )
    )
    {
        correct(psi);
        left = residual(psi, source);
        const bool stalls = left/factor > 0.5*result.finalResidual();
        result.finalResidual() = left/factor;
        ++result.nIterations();
        if (stalls)
        {
            break;
        }
    }
    result.checkConvergence(tolerance, relTol);
    return result;
}


// ************************************************************************* //
