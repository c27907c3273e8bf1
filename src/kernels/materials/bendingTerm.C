// SPDX-License-Identifier: GPL-3.0-or-later

#include "bendingTerm.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::bendingTerm::angle
(
    const label i,
    const constNodes& x,
    FixedList<scalar, 6>& gradient
) const
{
    const FixedList<label, 3>& n = nodes_[i];
    const scalar ax = x(n[1], 0) - x(n[0], 0), ay = x(n[1], 1) - x(n[0], 1);
    const scalar bx = x(n[2], 0) - x(n[1], 0), by = x(n[2], 1) - x(n[1], 1);
    const scalar a2 = ax*ax + ay*ay, b2 = bx*bx + by*by;

    gradient[0] = -ay/a2;
    gradient[1] = ax/a2;
    gradient[4] = -by/b2;
    gradient[5] = bx/b2;
    gradient[2] = -gradient[0] - gradient[4];
    gradient[3] = -gradient[1] - gradient[5];
    return std::atan2(ax*by - ay*bx, ax*bx + ay*by);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bendingTerm::bendingTerm
(
    const shapeMesh& mesh,
    const membraneMaterial& material,
    const scalar thickness
)
:
    nodes_(mesh.nBoundary),
    stiffness_(mesh.nBoundary),
    restAngles_(mesh.nBoundary)
{
    for (const surfaceFace& face : mesh.faces)
    {
        nodes_[face[0]][1] = face[0];
        nodes_[face[0]][2] = face[1];
        nodes_[face[1]][0] = face[0];
    }

    Eigen::MatrixXd x(mesh.points.size(), 2);
    forAll(mesh.points, nodei)
    {
        x(nodei, 0) = mesh.points[nodei].x();
        x(nodei, 1) = mesh.points[nodei].y();
    }
    FixedList<scalar, 6> gradient;
    forAll(nodes_, i)
    {
        const point& here = mesh.points[i];
        const scalar length = 0.5
           *(
                mag(here - mesh.points[nodes_[i][0]])
              + mag(here - mesh.points[nodes_[i][2]])
            );
        stiffness_[i] = material.bendingModulus*thickness/length;
        restAngles_[i] =
            material.shapeCurvature
          ? angle(i, x, gradient)
          : material.restCurvature*length;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::bendingTerm::energy(const constNodes& x) const
{
    scalar sum = 0;
    FixedList<scalar, 6> gradient;
    forAll(nodes_, i)
    {
        sum += 0.5*stiffness_[i]*sqr(angle(i, x, gradient) - restAngles_[i]);
    }
    return sum;
}


void Foam::fsi::bendingTerm::addForce(const constNodes& x, nodes force) const
{
    FixedList<scalar, 6> gradient;
    forAll(nodes_, i)
    {
        const scalar turn = angle(i, x, gradient) - restAngles_[i];
        const scalar moment = stiffness_[i]*turn;
        forAll(gradient, k)
        {
            force(nodes_[i][k/2], k % 2) -= moment*gradient[k];
        }
    }
}


void Foam::fsi::bendingTerm::addStiffness
(
    const constNodes& x,
    const scalar factor,
    entries& matrix
) const
{
    FixedList<scalar, 6> gradient;
    forAll(nodes_, i)
    {
        angle(i, x, gradient);
        forAll(gradient, k)
        {
            const label row = nodes_[i][k/2] + x.rows()*(k % 2);
            forAll(gradient, j)
            {
                matrix.emplace_back
                (
                    row,
                    nodes_[i][j/2] + x.rows()*(j % 2),
                    factor*stiffness_[i]*gradient[k]*gradient[j]
                );
            }
        }
    }
}


// ************************************************************************* //
