// SPDX-License-Identifier: GPL-3.0-or-later

#include "patchTest.H"
#include "ListOps.H"
#include "openfoamVersion.H"
#include "rigidSupport.H"

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


//- Entries of the stiffness matrix of the network at rest; unknown
//  nDims*node + i
static matrixEntries linearStiffness
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const scalarField& springConstants,
    const volumeTerm& elementTerm
)
{
    const label nDims = mesh.nDims();
    matrixEntries entries;

    forAll(springs, springi)
    {
        const label a = springs[springi][0];
        const label b = springs[springi][1];
        vector n = mesh.points[b] - mesh.points[a];
        n /= mag(n);

        label unknowns[6];
        scalar g[6];
        for (label i = 0; i < nDims; ++i)
        {
            unknowns[i] = nDims*a + i;
            unknowns[nDims + i] = nDims*b + i;
            g[i] = -n[i];
            g[nDims + i] = n[i];
        }
        addProduct(2*nDims, unknowns, g, springConstants[springi], entries);
    }

    // The divergence, with half of the stiffness (see volumeTerm)
    const strainDomains& domains = elementTerm.volumeDomains();
    std::vector<label> unknowns;
    for (label domaini = 0; domaini < domains.size(); ++domaini)
    {
        const scalar stiffness =
            0.5*elementTerm.stiffness()*domains.volumes()[domaini];
        unknowns.clear();
        const label start = domains.start(domaini);
        for (label j = start; j < domains.start(domaini + 1); ++j)
        {
            for (label i = 0; i < nDims; ++i)
            {
                unknowns.push_back(nDims*domains.nodes()[j] + i);
            }
        }
        addProduct
        (
            unknowns.size(),
            unknowns.data(),
            &domains.gradients()[nDims*start],
            stiffness,
            entries
        );
    }

    return entries;
}


//- Matrix with the supported unknowns held at zero
static Eigen::SparseMatrix<double> supported
(
    const matrixEntries& entries,
    const shapeMesh& mesh
)
{
    const labelList held(rigidSupport(mesh));

    matrixEntries kept;
    scalar largest = 0;
    for (const auto& entry : entries)
    {
        if (!isIn(held, entry.row()) && !isIn(held, entry.col()))
        {
            kept.push_back(entry);
            largest = max(largest, entry.value());
        }
    }
    for (const label unknown : held)
    {
        kept.emplace_back(unknown, unknown, largest);
    }

    const label n = mesh.nDims()*mesh.points.size();
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(kept.begin(), kept.end());
    return matrix;
}


//- Components of the unit stresses: xx, yy, xy or xx, yy, zz, xy, yz, zx
static std::vector<std::pair<label, label>> stresses(const label nDims)
{
    if (nDims == 2)
    {
        return {{0, 0}, {1, 1}, {0, 1}};
    }
    return {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
}


//- Sums over the boundary of some elements. With the normals of area, the
//  columns are the nodal forces of the unit stresses; their transpose times
//  displacements gives the strains, times volume.
static Eigen::MatrixXd boundarySums
(
    const shapeMesh& mesh,
    const labelList& elements,
    const scalar thickness
)
{
    const label nDims = mesh.nDims();
    const auto loads = stresses(nDims);
    Eigen::MatrixXd sums =
        Eigen::MatrixXd::Zero(nDims*mesh.points.size(), loads.size());
    for (const label elementi : elements)
    {
        const bodyElement& e = mesh.elements[elementi];
        for (label i = 0; i < nDims + 1; ++i)
        {
            // A node's part of the sides that it has in the element
            const vector n =
                thickness*strainDomains::volumeGradient(mesh, e, i);
            for (std::size_t load = 0; load < loads.size(); ++load)
            {
                const label k = loads[load].first, l = loads[load].second;
                sums(nDims*e[i] + k, load) += n[l];
                if (k != l)
                {
                    sums(nDims*e[i] + l, load) += n[k];
                }
            }
        }
    }
    return sums;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Eigen::MatrixXd> Foam::fsi::patchTest::compliances
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
        boundarySums(mesh, identityList(mesh.elements.size()), thickness)
    );
    for (const label unknown : rigidSupport(mesh))
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

    std::vector<Eigen::MatrixXd> result;
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
    const Eigen::MatrixXd& S,
    const vector& n
)
{
    if (S.rows() == 3)
    {
        const Eigen::Matrix3d plane(S);
        const Eigen::Vector3d stress(sqr(n.x()), sqr(n.y()), n.x()*n.y());
        return stress.dot(plane*stress);
    }
    Eigen::VectorXd stress(6);
    stress <<
        sqr(n.x()), sqr(n.y()), sqr(n.z()),
        n.x()*n.y(), n.y()*n.z(), n.z()*n.x();
    return stress.dot(S*stress);
}


// ************************************************************************* //
