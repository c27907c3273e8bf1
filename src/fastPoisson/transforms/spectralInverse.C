// SPDX-License-Identifier: GPL-3.0-or-later

#include "spectralInverse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::direction Foam::fsi::spectralInverse::lastThick(const labelVector& n)
{
    return n.z() > 1 ? 2 : n.y() > 1 ? 1 : 0;
}


void Foam::fsi::spectralInverse::makePlans
(
    const FixedList<boxTransform::ends, 3>& kinds
)
{
    kinds_ = kinds;
    FixedList<bool, 3> inSlab(true);
    inSlab[last_] = !shared_;
    FixedList<bool, 3> inColumn(false);
    inColumn[last_] = true;

    slab_.reset(new boxTransform(slabs_.layout(rank_).n(), kinds, inSlab));
    if (shared_)
    {
        column_.reset
        (
            new boxTransform(columns_.layout(rank_).n(), kinds, inColumn)
        );
    }
}


void Foam::fsi::spectralInverse::divide
(
    const blockLayout& box,
    double* values
) const
{
    const labelVector& start = box.start();
    const label nx = box.n().x();
    const scalar* x = eigenvalues_[0].cdata() + start.x();
    double* row = values;
    for (label k = 0; k < box.n().z(); ++k)
    {
        for (label j = 0; j < box.n().y(); ++j)
        {
            const scalar yz =
                constant_
              + eigenvalues_[1][start.y() + j]
              + eigenvalues_[2][start.z() + k];

            // Only the constant can have the eigenvalue zero
            const label first = x[0] + yz <= 0 ? 1 : 0;
            if (first)
            {
                row[0] /= zeroMode_;
            }
            #pragma omp simd
            for (label i = first; i < nx; ++i)
            {
                row[i] /= x[i] + yz;
            }
            row += nx;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::spectralInverse::spectralInverse(const cartesianLattice& lattice)
:
    rank_(lattice.rank()),
    last_(lastThick(lattice.map().n())),
    slabs_(lattice.partition().slabs(last_, lattice.nRanks())),
    columns_
    (
        lattice.partition().slabs(last_ > 0 ? last_ - 1 : 1, lattice.nRanks())
    ),
    shared_(lattice.nRanks() > 1),
    transfer_(lattice.map(), slabs_),
    constant_(0),
    zeroMode_(1)
{
    if (shared_)
    {
        remap_.reset(new boxRemap(slabs_, columns_, lattice.comm()));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::spectralInverse::set
(
    const FixedList<boxTransform::ends, 3>& kinds,
    const vector& face,
    const scalar constant
)
{
    if (!slab_.valid() || kinds != kinds_)
    {
        makePlans(kinds);
    }

    scalar scale = 1;
    for (direction d = 0; d < 3; ++d)
    {
        scale *= boxTransform::scale(slabs_.n(d), kinds[d]);
    }
    for (direction d = 0; d < 3; ++d)
    {
        eigenvalues_[d] =
            scale*face[d]*boxTransform::eigenvalues(slabs_.n(d), kinds[d]);
    }
    constant_ = scale*constant;
    const label longest = eigenvalues_[0].size() > 1 ? 1 : 0;
    zeroMode_ = max(eigenvalues_[0][longest], VSMALL);
}


void Foam::fsi::spectralInverse::apply(const scalarField& b, scalarField& x)
{
    double* values = slab_->values();
    transfer_.toBlock(b, 1, values);
    slab_->forward();
    if (shared_)
    {
        remap_->forward(values, column_->values());
        column_->forward();
        divide(columns_.layout(rank_), column_->values());
        column_->backward();
        remap_->backward(column_->values(), values);
    }
    else
    {
        divide(slabs_.layout(rank_), values);
    }
    slab_->backward();
    transfer_.toCells(values, 1, x);
}


// ************************************************************************* //
