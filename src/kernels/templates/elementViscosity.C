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
static void addForceOfCopy
(
    const shapeTemplate& shape,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const Eigen::Ref<const Eigen::MatrixXd>& v,
    Eigen::Ref<Eigen::MatrixXd> force
)
{
    const strainDomains& domains = shape.elementTerm().shearDomains();
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        scalar F[4], rate[4];
        domains.gradient(domaini, x, true, F);
        domains.gradient(domaini, v, false, rate);

        // Gradients in space are (cof F) g, where areas are kept
        Eigen::Matrix2d cofactors, dF;
        cofactors << F[3] + 1, -F[2], -F[1], F[0] + 1;
        dF << rate[0], rate[1], rate[2], rate[3];
        const Eigen::Matrix2d gradient = dF*cofactors.transpose();
        const scalar viscosity =
            shape.viscosity()
           *min(1.0, largestStretchSqr/cofactors.squaredNorm());
        const Eigen::Matrix2d P =
            viscosity*domains.volumes()[domaini]
           *(gradient + gradient.transpose())*cofactors;
        domains.addForce
        (
            domaini, {P(0, 0), P(0, 1), P(1, 0), P(1, 1)}, force
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
    for (const label copyi : copies)
    {
        const label column = 2*copyi;
        addForceOfCopy
        (
            shape,
            positions.middleCols(column, 2),
            velocities.middleCols(column, 2),
            force.middleCols(column, 2)
        );
    }
}


// ************************************************************************* //
