// SPDX-License-Identifier: GPL-3.0-or-later

#include "pressureLevels.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Key of a pair of objects
static unsigned long pairOf(const label a, const label b)
{
    return (static_cast<unsigned long>(a) << 32) | b;
}


//- Functions of the cells across coupled faces, by boundary face
static List<pressureLevels::cellValues> acrossFaces
(
    const polyMesh& mesh,
    const UList<pressureLevels::cellValues>& values
)
{
    static_assert(pressureLevels::nNearest == vector::nComponents, "packing");
    vectorField objects(values.size()), weights(values.size());
    forAll(values, celli)
    {
        for (label i = 0; i < pressureLevels::nNearest; ++i)
        {
            objects[celli][i] = values[celli].object[i];
            weights[celli][i] = values[celli].value[i];
        }
    }
    List<vector> objectsAcross, weightsAcross;
    syncTools::swapBoundaryCellList(mesh, objects, objectsAcross);
    syncTools::swapBoundaryCellList(mesh, weights, weightsAcross);

    List<pressureLevels::cellValues> across(objectsAcross.size());
    forAll(across, facei)
    {
        for (label i = 0; i < pressureLevels::nNearest; ++i)
        {
            across[facei].object[i] = label(objectsAcross[facei][i]);
            across[facei].value[i] = weightsAcross[facei][i];
        }
    }
    return across;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::pressureLevels::addFace
(
    const cellValues& a,
    const cellValues& b,
    const scalar coefficient
)
{
    // Merge the two ordered lists into differences
    label object[2*nNearest];
    scalar difference[2*nNearest];
    label n = 0;
    const auto more = [](const cellValues& v, const label i)
    {
        return i < nNearest && v.object[i] >= 0;
    };
    for (label i = 0, j = 0; more(a, i) || more(b, j);)
    {
        const bool takesA =
            more(a, i) && (!more(b, j) || a.object[i] <= b.object[j]);
        const bool takesB =
            more(b, j) && (!more(a, i) || b.object[j] <= a.object[i]);
        object[n] = takesA ? a.object[i] : b.object[j];
        difference[n] =
            (takesA ? a.value[i] : 0) - (takesB ? b.value[j] : 0);
        i += takesA;
        j += takesB;
        n += difference[n] != 0;
    }
    // The same objects as at the last face, mostly
    if (n != sameN_ || !std::equal(object, object + n, sameObjects_))
    {
        sameN_ = n;
        std::copy(object, object + n, sameObjects_);
        scalar** sum = sameSums_;
        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j <= i; ++j)
            {
                *sum++ = &sums_[pairOf(object[i], object[j])];
            }
        }
    }
    scalar** sum = sameSums_;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            **sum++ += coefficient*difference[i]*difference[j];
        }
    }
}


void Foam::fsi::pressureLevels::sumFaces(const fvScalarMatrix& matrix)
{
    sums_.clear();
    sameN_ = 0;
    const labelUList& lower = matrix.lduAddr().lowerAddr();
    const labelUList& upper = matrix.lduAddr().upperAddr();
    const scalarField& coefficients = matrix.upper();
    forAll(lower, facei)
    {
        if (coefficients[facei] != 0)
        {
            addFace
            (
                values_[lower[facei]],
                values_[upper[facei]],
                mag(coefficients[facei])
            );
        }
    }

    const fvBoundaryMesh& boundary = system_.grid.mesh().boundary();
    forAll(boundary, patchi)
    {
        // A fixed pressure
        const labelUList& cells = boundary[patchi].faceCells();
        for (label i = 0; i < cells.size() && !boundary[patchi].coupled(); ++i)
        {
            addFace
            (
                values_[cells[i]],
                cellValues(),
                mag(matrix.internalCoeffs()[patchi][i])
            );
        }
    }
    sumCoupled(matrix);
}


void Foam::fsi::pressureLevels::sumCoupled(const fvScalarMatrix& matrix)
{
    const fvMesh& mesh = system_.grid.mesh();
    bool coupled = false;
    forAll(mesh.boundary(), patchi)
    {
        coupled = coupled || mesh.boundary()[patchi].coupled();
    }
    if (!returnReduce(coupled, orOp<bool>()))
    {
        return;
    }

    const List<cellValues> across(acrossFaces(mesh, values_));
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const label start = patch.start() - mesh.nInternalFaces();
        for (label i = 0; i < patch.size() && patch.coupled(); ++i)
        {
            // Met from both sides
            addFace
            (
                values_[patch.faceCells()[i]],
                across[start + i],
                0.5*mag(matrix.internalCoeffs()[patchi][i])
            );
        }
    }
}


void Foam::fsi::pressureLevels::factor(const scalar largest)
{
    // Row, column and value of each sum
    List<scalarList> all(Pstream::nProcs());
    scalarList& own = all[Pstream::myProcNo()];
    own.setSize(3*sums_.size());
    label place = 0;
    for (const auto& sum : sums_)
    {
        own[place++] = sum.first >> 32;
        own[place++] = sum.first & 0xffffffff;
        own[place++] = sum.second;
    }
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    const label n = system_.objects.size();
    std::vector<Eigen::Triplet<scalar>> triplets;
    scalarField diagonal(n, Zero);
    scalar total = 0;
    for (const scalarList& sums : all)
    {
        for (label i = 0; i < sums.size(); i += 3)
        {
            triplets.emplace_back(sums[i], sums[i + 1], sums[i + 2]);
            const bool onDiagonal = sums[i] == sums[i + 1];
            total += (onDiagonal ? 1 : 2)*sums[i + 2];
            if (onDiagonal)
            {
                diagonal[label(sums[i])] += sums[i + 2];
            }
        }
    }

    // Without a fixed pressure the mean level is free: its residual, which is
    // nothing but rounding errors, must not be blown up
    floating_ = total < 1e-6*sum(diagonal) + largest;
    for (label i = 0; i < n; ++i)
    {
        triplets.emplace_back(i, i, 1e-4*max(diagonal[i], largest));
    }
    Eigen::SparseMatrix<scalar> E(n, n);
    E.setFromTriplets(triplets.begin(), triplets.end());
    factor_.compute(E);
}


// ************************************************************************* //
