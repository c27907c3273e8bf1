// SPDX-License-Identifier: GPL-3.0-or-later

#include "constantCoefficients.H"
#include "latticeRanks.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

// Coefficients may differ by this part: points have six digits in ASCII
constexpr Foam::scalar tolerance = 1e-5;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Visitor>
void Foam::fsi::constantCoefficients::forCells(const Visitor& visit) const
{
    const blockLayout& box = matrix_.lattice().layout();
    const labelVector& n = box.n();
    for (label k = 0; k < n.z(); ++k)
    {
        for (label j = 0; j < n.y(); ++j)
        {
            const label row = box.index(0, j, k);
            for (label i = 0; i < n.x(); ++i)
            {
                visit(row + i, labelVector(i, j, k) + box.start());
            }
        }
    }
}


void Foam::fsi::constantCoefficients::findFaces()
{
    const cartesianMap& map = matrix_.lattice().map();
    const label comm = matrix_.lattice().comm();
    for (direction d = 0; d < 3; ++d)
    {
        scalar least = GREAT;
        scalar most = 0;
        scalar total = 0;
        scalar count = 0;
        forCells
        (
            [&](const label place, const labelVector& cell)
            {
                const bool inside = cell[d] > 0 || map.cyclic()[d];
                if (map.n()[d] > 1 && inside)
                {
                    const scalar a = matrix_.A().face[d][place];
                    least = min(least, a);
                    most = max(most, a);
                    total += a;
                    ++count;
                }
            }
        );
        reduceOverRanks(least, minOp<scalar>(), comm);
        reduceOverRanks(most, maxOp<scalar>(), comm);
        reduceOverRanks(total, sumOp<scalar>(), comm);
        reduceOverRanks(count, sumOp<scalar>(), comm);
        face_[d] = count > 0 ? total/count : 0;
        if (count > 0 && most - least > tolerance*face_[d])
        {
            reason_ =
                "coefficients of faces in the mesh's direction "
              + Foam::name(label(map.axis(d))) + " are between "
              + Foam::name(least) + " and " + Foam::name(most);
        }
    }
}


void Foam::fsi::constantCoefficients::findSides()
{
    const cartesianMap& map = matrix_.lattice().map();
    const label comm = matrix_.lattice().comm();
    FixedList<scalar, 7> least(GREAT);
    forCells
    (
        [&](const label place, const labelVector& cell)
        {
            const scalar excess = matrix_.rowSum()[place];
            least[6] = min(least[6], excess);
            for (direction d = 0; d < 3; ++d)
            {
                if (cell[d] == 0)
                {
                    least[2*d] = min(least[2*d], excess);
                }
                if (cell[d] == map.n()[d] - 1)
                {
                    least[2*d + 1] = min(least[2*d + 1], excess);
                }
            }
        }
    );
    for (scalar& value : least)
    {
        reduceOverRanks(value, minOp<scalar>(), comm);
    }

    // A sum of coefficients that cancel is not a time derivative
    const scalar size = face_.x() + face_.y() + face_.z();
    diagonal_ = mag(least[6]) < 1e-10*size ? 0 : least[6];
    for (label side = 0; side < 6; ++side)
    {
        // 2 a for a value, as it is half a cell away; 0 for a gradient
        fixed_[side] = least[side] - diagonal_ > 1.5*face_[side/2];
        fixed_[side] = fixed_[side] && face_[side/2] > 0;
    }
}


void Foam::fsi::constantCoefficients::findReference()
{
    const cartesianMap& map = matrix_.lattice().map();
    const label comm = matrix_.lattice().comm();
    label nDifferent = 0;
    forCells
    (
        [&](const label place, const labelVector& cell)
        {
            scalar expected = diagonal_;
            for (direction d = 0; d < 3; ++d)
            {
                const bool low = cell[d] == 0 && fixed_[2*d];
                const bool high =
                    cell[d] == map.n()[d] - 1 && fixed_[2*d + 1];
                expected += 2*face_[d]*(label(low) + label(high));
            }
            const scalar excess = matrix_.rowSum()[place] - expected;
            if (mag(excess) > tolerance*matrix_.A().diagonal[place])
            {
                ++nDifferent;
                referencePlace_ = place;
                referenceExcess_ = excess;
            }
        }
    );
    reduceOverRanks(nDifferent, sumOp<label>(), comm);
    reduceOverRanks(referenceExcess_, sumOp<scalar>(), comm);
    const bool reference =
        nDifferent == 1 && referenceExcess_ > 0 && singular();
    if (nDifferent > 0 && !reference)
    {
        reason_ =
            "the diagonals of " + Foam::name(nDifferent)
          + " cells are not those of a constant with whole sides of one kind";
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::constantCoefficients::constantCoefficients
(
    const structuredMatrix& matrix
)
:
    matrix_(matrix),
    face_(Zero),
    diagonal_(0),
    fixed_(false),
    referencePlace_(-1),
    referenceExcess_(0)
{
    findFaces();
    findSides();
    findReference();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::constantCoefficients::singular() const
{
    return diagonal_ <= 0 && !isIn(fixed_, true);
}


Foam::FixedList<Foam::fsi::boxTransform::ends, 3>
Foam::fsi::constantCoefficients::kinds() const
{
    FixedList<boxTransform::ends, 3> result;
    for (direction d = 0; d < 3; ++d)
    {
        const bool low = fixed_[2*d];
        const bool high = fixed_[2*d + 1];
        result[d] =
            matrix_.lattice().map().cyclic()[d] ? boxTransform::ends::cyclic
          : low && high ? boxTransform::ends::value
          : low ? boxTransform::ends::valueLow
          : high ? boxTransform::ends::valueHigh
          : boxTransform::ends::gradient;
    }
    return result;
}


// ************************************************************************* //
