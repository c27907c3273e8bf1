// SPDX-License-Identifier: GPL-3.0-or-later

#include "stepMatrix.H"
#include "elementViscosity.H"
#include "shearTerm.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Masses and springs
static void addNodesAndSprings
(
    const shapeTemplate& shape,
    const scalar dt,
    matrixEntries& entries
)
{
    const scalarField masses(stepMasses(shape, dt));
    forAll(masses, nodei)
    {
        entries.emplace_back(nodei, nodei, masses[nodei]);
    }
    const scalarField weights(sqr(dt)*shape.springWeights(dt));
    forAll(shape.springs(), springi)
    {
        const label a = shape.springs()[springi][0];
        const label b = shape.springs()[springi][1];
        entries.emplace_back(a, a, weights[springi]);
        entries.emplace_back(b, b, weights[springi]);
        entries.emplace_back(a, b, -weights[springi]);
        entries.emplace_back(b, a, -weights[springi]);
    }
}


//- Volumes, shear and viscosity
static void addElements
(
    const shapeTemplate& shape,
    const scalar dt,
    matrixEntries& entries
)
{
    const volumeTerm& term = shape.elementTerm();
    const scalar volumeWeight =
        sqr(dt)*shape.admm().areaWeight*term.stiffness();
    const scalar shearWeight =
        shearTerm::bound(shape.nDims())*sqr(dt)*shape.shearModulus()
      + dt*elementViscosity::boundRatio*shape.viscosity();
    if (shape.nDims() == 3)
    {
        const strainDomains elements
        (
            shape.mesh(), 1, strainDomains::kind::element
        );
        elements.addLaplacian(volumeWeight + shearWeight, entries);
        return;
    }
    term.volumeDomains().addLaplacian(volumeWeight, entries);
    term.shearDomains().addLaplacian(shearWeight, entries);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::stepMasses
(
    const shapeTemplate& shape,
    const scalar dt
)
{
    scalarField masses(shape.nodeMasses());
    if (!shape.held().empty())
    {
        // A clamp is far heavier than the body and its stiffness
        const scalar size =
            shape.nDims() == 2
          ? shape.thickness()
          : std::cbrt(shape.referenceVolume());
        const scalar modulus = shape.rigid() ? 0 : shape.youngsModulus();
        const scalarField added
        (
            shape.held().masses
            (
                dt, 1e8*(shape.mass() + sqr(dt)*modulus*size)
            )
        );
        forAll(added, i)
        {
            masses[shape.held().nodes()[i]] += added[i];
        }
    }
    return masses;
}


Eigen::SparseMatrix<double> Foam::fsi::stepMatrix
(
    const shapeTemplate& shape,
    const scalar dt
)
{
    matrixEntries entries;
    addNodesAndSprings(shape, dt, entries);
    addElements(shape, dt, entries);
    Eigen::SparseMatrix<double> matrix(shape.nNodes(), shape.nNodes());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}


// ************************************************************************* //
