// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencilCycle.H"
#include "stencilRows.H"

namespace Foam
{
namespace fsi
{

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

template<bool threeD>
FSI_INLINE void allRows
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x,
    float* work
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        rowSweep<threeD>(A, r, colour, b, x, work);
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

FSI_VECTOR_CLONES
void sweepFromZero
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        rowFromZero(A, r, colour, b, x);
    }
}


FSI_VECTOR_CLONES
void sweep
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x,
    float* work
)
{
    if (A.threeD)
    {
        allRows<true>(A, colour, b, x, work);
    }
    else
    {
        allRows<false>(A, colour, b, x, work);
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
