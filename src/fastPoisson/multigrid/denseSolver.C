// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseSolver.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::denseSolver::addMeanTerm(scalarField& matrix) const
{
    scalar total = 0;
    scalar largest = 0;
    label nActive = 0;
    for (label i = 0; i < n_; ++i)
    {
        for (label j = 0; j < n_; ++j)
        {
            total += matrix[n_*i + j];
        }
        largest = max(largest, matrix[n_*i + i]);
        nActive += matrix[n_*i + i] > 0;
    }
    if (nActive == 0 || total > 1e-9*largest)
    {
        return;
    }

    for (label i = 0; i < n_; ++i)
    {
        for (label j = 0; j < n_; ++j)
        {
            // The diagonal of row j or i may have changed, not its sign
            if (matrix[n_*i + i] > 0 && matrix[n_*j + j] > 0)
            {
                matrix[n_*i + j] += largest/nActive;
            }
        }
    }
}


void Foam::fsi::denseSolver::factorise(scalarField& matrix) const
{
    for (label j = 0; j < n_; ++j)
    {
        const scalar diagonal = matrix[n_*j + j];
        scalar pivot = diagonal;
        for (label k = 0; k < j; ++k)
        {
            pivot -= sqr(matrix[n_*j + k]);
        }
        const bool regular = diagonal > 0 && pivot > 1e-10*diagonal;
        const scalar root = regular ? std::sqrt(pivot) : 0;
        matrix[n_*j + j] = root;

        for (label i = j + 1; i < n_; ++i)
        {
            scalar value = matrix[n_*i + j];
            for (label k = 0; k < j; ++k)
            {
                value -= matrix[n_*i + k]*matrix[n_*j + k];
            }
            matrix[n_*i + j] = regular ? value/root : 0;
        }
        if (!regular)
        {
            // Its own row must not enter the others either
            for (label k = 0; k < j; ++k)
            {
                matrix[n_*j + k] = 0;
            }
        }
    }
}


void Foam::fsi::denseSolver::invertColumn
(
    const scalarField& factor,
    const label column
)
{
    scalar* x = &inverse_[n_*column];
    for (label i = 0; i < n_; ++i)
    {
        scalar value = i == column ? 1 : 0;
        for (label k = column; k < i; ++k)
        {
            value -= factor[n_*i + k]*x[k];
        }
        const scalar pivot = factor[n_*i + i];
        x[i] = (i < column || pivot == 0) ? 0 : value/pivot;
    }
    for (label i = n_ - 1; i >= 0; --i)
    {
        scalar value = x[i];
        for (label k = i + 1; k < n_; ++k)
        {
            value -= factor[n_*k + i]*x[k];
        }
        const scalar pivot = factor[n_*i + i];
        x[i] = pivot == 0 ? 0 : value/pivot;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::denseSolver::set(const label n, scalarField matrix)
{
    n_ = n;
    inverse_.setSize(n*n);
    b_.setSize(n, 0);
    x_.setSize(n, 0);

    addMeanTerm(matrix);
    factorise(matrix);
    for (label column = 0; column < n; ++column)
    {
        invertColumn(matrix, column);
    }
}


const Foam::scalarField& Foam::fsi::denseSolver::solve()
{
    for (label i = 0; i < n_; ++i)
    {
        const scalar* row = &inverse_[n_*i];
        scalar sum = 0;
        #pragma omp simd reduction(+:sum)
        for (label j = 0; j < n_; ++j)
        {
            sum += row[j]*b_[j];
        }
        x_[i] = sum;
    }
    return x_;
}


// ************************************************************************* //
