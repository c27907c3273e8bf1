// SPDX-License-Identifier: GPL-3.0-or-later

#include "patchTest.H"
#include "ListOps.H"

#include <Eigen/SparseCholesky>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef std::vector<Eigen::Triplet<double>> matrixEntries;

//- Add stiffness*g g^T for a vector g over the given unknowns
static void addProduct
(
    const label n,
    const label* unknowns,
    const scalar* g,
    const scalar stiffness,
    matrixEntries& entries
)
{
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            entries.emplace_back
            (
                unknowns[i],
                unknowns[j],
                stiffness*g[i]*g[j]
            );
        }
    }
}


//- Entries of the stiffness matrix of the network at rest; unknown 2*node + i
static matrixEntries linearStiffness
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const scalarField& springConstants,
    const volumeTerm& elementTerm
)
{
    matrixEntries entries;

    forAll(springs, springi)
    {
        const label a = springs[springi].first();
        const label b = springs[springi].second();
        vector n = mesh.points[b] - mesh.points[a];
        n /= mag(n);

        const label unknowns[4] = {2*a, 2*a + 1, 2*b, 2*b + 1};
        const scalar g[4] = {-n.x(), -n.y(), n.x(), n.y()};
        addProduct(4, unknowns, g, springConstants[springi], entries);
    }

    // The divergence, with half of the stiffness (see volumeTerm)
    const strainDomains& domains = elementTerm.areaDomains();
    std::vector<label> unknowns;
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        unknowns.clear();
        const label start = domains.start(domaini);
        for (label j = start; j < domains.start(domaini + 1); ++j)
        {
            unknowns.push_back(2*domains.nodes()[j]);
            unknowns.push_back(2*domains.nodes()[j] + 1);
        }
        const scalar stiffness =
            0.5*elementTerm.stiffness()*domains.volumes()[domaini];
        addProduct
        (
            unknowns.size(),
            unknowns.data(),
            &domains.gradients()[2*start],
            stiffness,
            entries
        );
    }

    return entries;
}


//- Three unknowns that hold a body against rigid motion
static FixedList<label, 3> support(const shapeMesh& mesh)
{
    label far = 1;
    forAll(mesh.points, pointi)
    {
        if
        (
            magSqr(mesh.points[pointi] - mesh.points[0])
          > magSqr(mesh.points[far] - mesh.points[0])
        )
        {
            far = pointi;
        }
    }
    const vector d = mesh.points[far] - mesh.points[0];
    const label across = mag(d.x()) > mag(d.y()) ? 1 : 0;

    FixedList<label, 3> unknowns;
    unknowns[0] = 0;
    unknowns[1] = 1;
    unknowns[2] = 2*far + across;
    return unknowns;
}


//- Matrix with the supported unknowns held at zero
static Eigen::SparseMatrix<double> supported
(
    const matrixEntries& entries,
    const shapeMesh& mesh
)
{
    const FixedList<label, 3> held(support(mesh));

    matrixEntries kept;
    scalar largest = 0;
    for (const auto& entry : entries)
    {
        if (!held.found(entry.row()) && !held.found(entry.col()))
        {
            kept.push_back(entry);
            largest = max(largest, entry.value());
        }
    }
    for (const label unknown : held)
    {
        kept.emplace_back(unknown, unknown, largest);
    }

    const label n = 2*mesh.points.size();
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(kept.begin(), kept.end());
    return matrix;
}


//- Sums over the boundary of some elements. With the normal (nx, ny) of area,
//  the columns are the nodal forces of the unit stresses xx, yy, xy; their
//  transpose times displacements gives the strains, times volume.
static Eigen::MatrixXd boundarySums
(
    const shapeMesh& mesh,
    const labelList& elements,
    const scalar thickness
)
{
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(2*mesh.points.size(), 3);
    for (const label elementi : elements)
    {
        const bodyElement& e = mesh.elements[elementi];
        for (label i = 0; i < 3; ++i)
        {
            // The sides that a node has in the element have the normal of
            // half the opposite side
            const vector d =
                mesh.points[e[(i + 1) % 3]] - mesh.points[e[(i + 2) % 3]];
            const scalar nx = 0.5*thickness*d.y(), ny = -0.5*thickness*d.x();
            sums(2*e[i], 0) += nx;
            sums(2*e[i] + 1, 1) += ny;
            sums(2*e[i], 2) += ny;
            sums(2*e[i] + 1, 2) += nx;
        }
    }
    return sums;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Eigen::Matrix3d> Foam::fsi::patchTest::compliances
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const scalarField& springConstants,
    const volumeTerm& elementTerm,
    const scalar thickness,
    const labelListList& regions
)
{
    Eigen::MatrixXd loads
    (
        boundarySums(mesh, identity(mesh.elements.size()), thickness)
    );
    for (const label unknown : support(mesh))
    {
        loads.row(unknown).setZero();
    }

    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver
    (
        supported
        (
            linearStiffness(mesh, springs, springConstants, elementTerm),
            mesh
        )
    );
    if (solver.info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "The spring network is not rigid" << exit(FatalError);
    }
    const Eigen::MatrixXd displacements = solver.solve(loads);

    std::vector<Eigen::Matrix3d> result;
    for (const labelList& region : regions)
    {
        const scalar volume =
            sum(scalarField(elementTerm.volumes(), region));
        result.push_back
        (
            boundarySums(mesh, region, thickness).transpose()*displacements
           /volume
        );
    }
    return result;
}


Foam::scalar Foam::fsi::patchTest::modulusInverse
(
    const Eigen::Matrix3d& S,
    const scalar angle
)
{
    const scalar c = std::cos(angle), s = std::sin(angle);
    const Eigen::Vector3d n(c*c, s*s, c*s);
    return n.dot(S*n);
}


// ************************************************************************* //
