// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementEnergy.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Energy of the area terms of a copy [J]; subtracts their derivative from
//  the nodes' forces, if there are any
static scalar areaEnergy
(
    const volumeTerm& term,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const label column,
    Eigen::MatrixXd* force
)
{
    const strainDomains& domains = term.areaDomains();
    scalar energy = 0;
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        scalar F[4];
        domains.gradient(domaini, x, true, F);
        F[0] += 1;
        F[3] += 1;
        const scalar stiffness = term.stiffness()*domains.volumes()[domaini];
        energy += 0.25*stiffness*sqr(F[0]*F[3] - F[1]*F[2] - 1);
        if (force)
        {
            volumeTerm::toGradient(F[0], F[1], F[2], F[3]);
            for (scalar& part : F)
            {
                part *= stiffness;
            }
            domains.addForce(domaini, F, force->middleCols(column, 2));
        }
    }
    return energy;
}


//- The same for the shear of neo-Hookean bodies
static scalar shearEnergy
(
    const shapeTemplate& shape,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const label column,
    Eigen::MatrixXd* force
)
{
    if (shape.shearModulus() == 0)
    {
        return 0;
    }
    const strainDomains& domains = shape.elementTerm().shearDomains();
    scalar energy = 0;
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        scalar F[4];
        domains.gradient(domaini, x, true, F);
        const scalar size =
            2*shape.shearModulus()*domains.volumes()[domaini];

        // The part that is not conformal is (c d; d -c)
        const scalar c = 0.5*(F[0] - F[3]);
        const scalar d = 0.5*(F[1] + F[2]);
        energy += size*(sqr(c) + sqr(d));
        if (force)
        {
            const scalar P[4] = {size*c, size*d, size*d, -size*c};
            domains.addForce(domaini, P, force->middleCols(column, 2));
        }
    }
    return energy;
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
    const auto x = positions.middleCols(2*copyi, 2);
    const scalar area = areaEnergy(shape.elementTerm(), x, 2*copyi, force);
    return area + shearEnergy(shape, x, 2*copyi, force);
}


// ************************************************************************* //
