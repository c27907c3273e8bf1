// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementEnergy.H"
#include "shearTerm.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Subtract size*P g_n from the forces of a copy, if there are any
template<int nDims>
static void spread
(
    const strainDomains& domains,
    const label domaini,
    const scalar size,
    scalar* P,
    const label copyi,
    Eigen::MatrixXd* force
)
{
    if (force)
    {
        for (int i = 0; i < nDims*nDims; ++i)
        {
            P[i] *= size;
        }
        domains.addForce(domaini, P, force->middleCols(nDims*copyi, nDims));
    }
}


//- Energy of the area or volume terms, and their forces
template<int nDims>
static scalar volumeEnergy
(
    const volumeTerm& term,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const label copyi,
    Eigen::MatrixXd* force
)
{
    const strainDomains& domains = term.volumeDomains();
    scalar energy = 0;
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        scalar F[nDims*nDims];
        domains.gradient(domaini, x, true, F);
        for (int i = 0; i < nDims; ++i)
        {
            F[(nDims + 1)*i] += 1;
        }
        const scalar size = term.stiffness()*domains.volumes()[domaini];
        energy += size*volumeTerm::energy<nDims>(F, term.shearPart());
        volumeTerm::toGradient<nDims>(F, term.shearPart());
        spread<nDims>(domains, domaini, size, F, copyi, force);
    }
    return energy;
}


//- Energy of the shear of neo-Hookean bodies
template<int nDims>
static scalar shearEnergy
(
    const shapeTemplate& shape,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const label copyi,
    Eigen::MatrixXd* force
)
{
    const scalar modulus = shape.shearModulus();
    if (modulus == 0)
    {
        return 0;
    }
    const shearMatrix& matrix = shape.elementTerm().shearForces();
    const pointField& X = shape.points();
    Eigen::Matrix<scalar, Eigen::Dynamic, nDims, Eigen::RowMajor> u
    (
        x.rowwise() - x.row(0)
    );
    forAll(X, node)
    {
        for (int k = 0; k < nDims; ++k)
        {
            u(node, k) -= X[node][k] - X[0][k];
        }
    }
    scalar energy = 0;
    for (label node = 0; node < matrix.size(); ++node)
    {
        scalar f[nDims];
        matrix.force<nDims, true>(node, u, f);
        for (int k = 0; k < nDims; ++k)
        {
            // A quadratic energy is half of the displacement times its force
            energy -= 0.5*modulus*u(node, k)*f[k];
            if (force)
            {
                (*force)(node, nDims*copyi + k) += modulus*f[k];
            }
        }
    }
    return energy;
}


//- Energy of the volume terms and of shear, and their forces
template<int nDims>
static scalar addEnergy
(
    const shapeTemplate& shape,
    const Eigen::MatrixXd& positions,
    const label copyi,
    Eigen::MatrixXd* force
)
{
    const auto x = positions.middleCols(nDims*copyi, nDims);
    return
        volumeEnergy<nDims>(shape.elementTerm(), x, copyi, force)
      + shearEnergy<nDims>(shape, x, copyi, force);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::addElementEnergy
(
    const shapeTemplate& shape,
    const Eigen::MatrixXd& positions,
    const label copyi,
    Eigen::MatrixXd* force
)
{
    return
        shape.nDims() == 2
      ? addEnergy<2>(shape, positions, copyi, force)
      : addEnergy<3>(shape, positions, copyi, force);
}


// ************************************************************************* //
