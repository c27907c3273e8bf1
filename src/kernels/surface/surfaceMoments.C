// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceMoments.H"

#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Second moments of the region that an object encloses
static symmTensor secondMoments
(
    const surfaceSet& surfaces,
    const label objecti,
    const point& centroid
)
{
    const label n = surfaces.nDims();
    const labelList& start = surfaces.faceStart();

    symmTensor sum(Zero);
    for (label facei = start[objecti]; facei < start[objecti + 1]; ++facei)
    {
        const surfaceFace& f = surfaces.faces()[facei];
        FixedList<vector, 3> p(Zero);
        symmTensor products(Zero);
        for (label i = 0; i < n; ++i)
        {
            p[i] = surfaces.points()[f[i]] - centroid;
            products += sqr(p[i]);
            for (label j = 0; j < i; ++j)
            {
                products += symm(p[i]*p[j]);
            }
        }
        const scalar volume = (surfaces.areaNormal(facei) & p[0])/n;
        sum += 2*volume/((n + 1)*(n + 2))*products;
    }
    return sum;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceMoments::surfaceMoments
(
    const surfaceSet& surfaces,
    const label objecti,
    const point& centroid
)
:
    moments_(secondMoments(surfaces, objecti, centroid)),
    halfLengths_(Zero),
    directions_(Zero)
{
    const direction n = surfaces.nDims();
    Eigen::Matrix3d M;
    M << moments_.xx(), moments_.xy(), moments_.xz(),
        moments_.xy(), moments_.yy(), moments_.yz(),
        moments_.xz(), moments_.yz(), moments_.zz();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver
    (
        M.topLeftCorner(n, n)
    );

    const scalar volume = surfaces.volume(objecti);
    for (direction i = 0; i < n; ++i)
    {
        // Eigenvalues come in rising order
        const direction k = n - 1 - i;
        halfLengths_[i] =
            sqrt(max((n + 2)*solver.eigenvalues()[k]/volume, scalar(0)));
        for (direction d = 0; d < n; ++d)
        {
            directions_[i][d] = solver.eigenvectors()(d, k);
        }
        if (directions_[i].x() < 0)
        {
            directions_[i] *= -1;
        }
    }
}


// ************************************************************************* //
