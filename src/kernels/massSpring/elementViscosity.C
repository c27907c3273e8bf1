// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementViscosity.H"
#include "innerFlow.H"

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
    scalar g[3][2];
    forAll(shape.elements(), elementi)
    {
        const bodyElement& element = shape.elements()[elementi];
        innerFlow::gradients(element, x, g);

        // Twice the rate of strain, times twice the area
        Eigen::Matrix2d rate = Eigen::Matrix2d::Zero();
        for (int a = 0; a < 3; ++a)
        {
            rate += v.row(element[a]).transpose()
               *Eigen::RowVector2d(g[a][0], g[a][1]);
        }
        const scalar area =
            shape.elementTerm().volumes()[elementi]/shape.thickness();
        const Eigen::Matrix2d stress =
            0.25*shape.viscosity()*shape.thickness()/area
           *(rate + rate.transpose());
        for (int a = 0; a < 3; ++a)
        {
            force.row(element[a]) -=
                (stress*Eigen::Vector2d(g[a][0], g[a][1])).transpose();
        }
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
