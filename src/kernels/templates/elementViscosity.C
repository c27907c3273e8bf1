// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementViscosity.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace elementViscosity
{

//- Add -N v of one copy
template<int nDims>
static void addForceOfCopy
(
    const shapeTemplate& shape,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const Eigen::Ref<const Eigen::MatrixXd>& v,
    Eigen::Ref<Eigen::MatrixXd> force
)
{
    typedef Eigen::Matrix<scalar, nDims, nDims> matrix;
    const int n = nDims*nDims;
    const strainDomains& domains = shape.elementTerm().shearDomains();
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        scalar F[n], rate[n], C[n];
        domains.gradient(domaini, x, true, F);
        domains.gradient(domaini, v, false, rate);
        for (int i = 0; i < nDims; ++i)
        {
            F[(nDims + 1)*i] += 1;
        }
        volumeTerm::cofactors<nDims>(F, C);

        // Gradients in space are (cof F) g, where volumes are kept
        matrix cofactors, dF;
        for (int i = 0; i < n; ++i)
        {
            cofactors(i/nDims, i % nDims) = C[i];
            dF(i/nDims, i % nDims) = rate[i];
        }
        const matrix gradient = dF*cofactors.transpose();
        const scalar viscosity =
            shape.viscosity()
           *min(1.0, largestStretchSqr/cofactors.squaredNorm());
        const matrix P =
            viscosity*domains.volumes()[domaini]
           *(gradient + gradient.transpose())*cofactors;
        for (int i = 0; i < n; ++i)
        {
            C[i] = P(i/nDims, i % nDims);
        }
        domains.addForce(domaini, C, force);
    }
}


//- Add the forces of a range of elements
template<int nDims>
static void addForces
(
    const shapeTemplate& shape,
    const Eigen::MatrixXd& positions,
    const Eigen::MatrixXd& velocities,
    const labelRange& copies,
    Eigen::MatrixXd& force
)
{
    for (const label copyi : copies)
    {
        const label column = nDims*copyi;
        addForceOfCopy<nDims>
        (
            shape,
            positions.middleCols(column, nDims),
            velocities.middleCols(column, nDims),
            force.middleCols(column, nDims)
        );
    }
}

} // End namespace elementViscosity
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::elementViscosity::addForce
(
    const shapeTemplate& shape,
    const Eigen::MatrixXd& positions,
    const Eigen::MatrixXd& velocities,
    const labelRange& copies,
    Eigen::MatrixXd& force
)
{
    if (shape.nDims() == 2)
    {
        addForces<2>(shape, positions, velocities, copies, force);
    }
    else
    {
        addForces<3>(shape, positions, velocities, copies, force);
    }
}


// ************************************************************************* //
