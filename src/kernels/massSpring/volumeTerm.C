// SPDX-License-Identifier: GPL-3.0-or-later

#include "volumeTerm.H"
#include "error.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::volumeTerm::volumeTerm
(
    const shapeMesh& mesh,
    const scalar thickness,
    const scalar stiffness
)
:
    stiffness_(stiffness),
    volumes_(mesh.elementVolumes()*thickness),
    edges_(4*mesh.elements.size()),
    inverseEdges_(4*mesh.elements.size())
{
    forAll(mesh.elements, elementi)
    {
        if (!(volumes_[elementi] > 0))
        {
            FatalErrorInFunction
                << "Element " << elementi << " with nodes "
                << mesh.elements[elementi]
                << " is not positively oriented" << exit(FatalError);
        }

        const bodyElement& element = mesh.elements[elementi];
        const point& origin = mesh.points[element[0]];
        const vector e1 = mesh.points[element[1]] - origin;
        const vector e2 = mesh.points[element[2]] - origin;
        const scalar det = e1.x()*e2.y() - e1.y()*e2.x();

        scalar* E = &edges_[4*elementi];
        E[0] = e1.x();
        E[1] = e1.y();
        E[2] = e2.x();
        E[3] = e2.y();

        // Inverse of the matrix with columns e1, e2
        scalar* B = &inverseEdges_[4*elementi];
        B[0] = e2.y()/det;
        B[1] = -e2.x()/det;
        B[2] = -e1.y()/det;
        B[3] = e1.x()/det;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::volumeTerm::addLaplacian
(
    const shapeMesh& mesh,
    const scalar weight,
    std::vector<Eigen::Triplet<double>>& entries
) const
{
    forAll(mesh.elements, elementi)
    {
        // Gradients of the shape functions
        const scalar* B = &inverseEdges_[4*elementi];
        const scalar gradients[3][2] =
        {
            {-B[0] - B[2], -B[1] - B[3]},
            {B[0], B[1]},
            {B[2], B[3]}
        };

        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j)
            {
                const scalar product =
                    gradients[i][0]*gradients[j][0]
                  + gradients[i][1]*gradients[j][1];

                entries.emplace_back
                (
                    mesh.elements[elementi][i],
                    mesh.elements[elementi][j],
                    weight*volumes_[elementi]*product
                );
            }
        }
    }
}


// ************************************************************************* //
