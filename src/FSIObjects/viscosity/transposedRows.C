// SPDX-License-Identifier: GPL-3.0-or-later

#include "transposedRows.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Cells of a row that are done at once
constexpr label rowLength = 128;

//- Arrays for the sum over the faces of a cell, see transposedRows
struct rowSource
{
    const scalar* u[3];
    const floatScalar* more;
    const floatScalar* fluid;
    label stride[3];
};

//- Sums in the cells from first on, without a factor
template<int nDims>
FSI_INLINE void sumRow
(
    const rowSource& from,
    const label first,
    const label n,
    scalar (*__restrict__ sum)[rowLength]
)
{
    const floatScalar* __restrict__ m = from.more + first;
    const floatScalar* __restrict__ f = from.fluid + first;
    for (int d = 0; d < nDims; ++d)
    {
        const label s = from.stride[d];
        const scalar* __restrict__ u = from.u[d] + first;
        for (int i = 0; i < nDims; ++i)
        {
            const label t = from.stride[i];
            scalar* __restrict__ result = sum[i];
            #pragma omp simd
            for (label x = 0; x < n; ++x)
            {
                const scalar here = u[x + t] - u[x - t];
                const scalar up = u[x + s + t] - u[x + s - t];
                const scalar down = u[x - s + t] - u[x - s - t];
                const scalar middle = m[x];
                const scalar ofUp = f[x + s]*(middle + m[x + s]);
                const scalar ofDown = f[x - s]*(middle + m[x - s]);
                result[x] +=
                    f[x]*(ofUp*(here + up) - ofDown*(here + down));
            }
        }
    }
}


FSI_AVX2_CLONES
void sumRow
(
    const label nDims,
    const rowSource& from,
    const label first,
    const label n,
    scalar (*sum)[rowLength]
)
{
    if (nDims == 2)
    {
        sumRow<2>(from, first, n, sum);
    }
    else
    {
        sumRow<3>(from, first, n, sum);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::transposedRows::setHalo(const volVectorField& U)
{
    for (const fvPatchVectorField& pU : U.boundaryField())
    {
        const vectorField beyond
        (
            pU.coupled()
          ? pU.patchNeighbourField()
          : 2*pU - pU.patchInternalField()
        );
        const labelUList& cells = pU.patch().faceCells();
        forAll(beyond, i)
        {
            const label at =
                place(cells[i]) + grid_.stepAcross(pU.patch().start() + i);
            for (direction d = 0; d < grid_.nDims(); ++d)
            {
                u_[d][at] = beyond[i][d];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::transposedRows::transposedRows
(
    const cartesianMesh& grid,
    const volVectorField& U,
    const scalarField& more,
    const scalar least,
    const boolList& fluid
)
:
    grid_(grid),
    margin_(grid.haloStride(grid.nDims() - 1)),
    more_(grid.cells(1).size() + 2*margin_, Zero),
    fluid_(more_.size(), Zero)
{
    for (direction d = 0; d < grid.nDims(); ++d)
    {
        u_[d].setSize(more_.size(), Zero);
    }
    forAll(more, celli)
    {
        const label at = place(celli);
        for (direction d = 0; d < grid.nDims(); ++d)
        {
            u_[d][at] = U[celli][d];
        }
        more_[at] = more[celli] - least;
        fluid_[at] = fluid[celli];
    }
    setHalo(U);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::transposedRows::gradient
(
    const label celli,
    const direction d
) const
{
    vector result(Zero);
    const scalar* u = u_[d].cdata() + place(celli);
    for (direction i = 0; i < grid_.nDims(); ++i)
    {
        const label t = grid_.haloStride(i);
        result[i] = (u[t] - u[-t])/(2*grid_.spacing());
    }
    return result;
}


void Foam::fsi::transposedRows::add(vectorField& source) const
{
    const direction nDims = grid_.nDims();
    rowSource from;
    for (direction d = 0; d < nDims; ++d)
    {
        from.u[d] = u_[d].cdata();
        from.stride[d] = grid_.haloStride(d);
    }
    from.more = more_.cdata();
    from.fluid = fluid_.cdata();

    // Two means of two cells, and differences over two cells
    const scalar factor = grid_.faceArea()/(8*grid_.spacing());
    const labelList& index = grid_.haloIndex();
    scalar sum[3][rowLength];
    for (label first = 0, n = 0; first < index.size(); first += n)
    {
        n = 1;
        while
        (
            n < rowLength && first + n < index.size()
         && index[first + n] == index[first] + n
        )
        {
            ++n;
        }
        std::fill(&sum[0][0], &sum[0][0] + nDims*rowLength, 0);
        sumRow(nDims, from, place(first), n, sum);
        for (label x = 0; x < n; ++x)
        {
            for (direction i = 0; i < nDims; ++i)
            {
                source[first + x][i] += factor*sum[i][x];
            }
        }
    }
}


// ************************************************************************* //
