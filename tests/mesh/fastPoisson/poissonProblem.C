// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonProblem.H"
#include "gaussLaplacianScheme.H"
#include "linear.H"
#include "openfoamVersion.H"
#include "orthogonalSnGrad.H"
#include "fvmSup.H"
#include "fvcSurfaceIntegrate.H"
#include "fvScalarMatrix.H"
#include "fixedValueFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::wordList patchTypes
(
    const Foam::fvMesh& mesh,
    const Foam::wordList& fixed
)
{
    Foam::wordList types(mesh.boundary().size());
    forAll(types, patchi)
    {
        const Foam::fvPatch& patch = mesh.boundary()[patchi];
        types[patchi] =
            Foam::polyPatch::constraintType(patch.type()) ? patch.type()
          : Foam::fsi::isIn(fixed, patch.name()) ? Foam::word("fixedValue")
          : Foam::word("zeroGradient");
    }
    return types;
}


// The scheme that any orthogonal case has, without files
Foam::fv::gaussLaplacianScheme<Foam::scalar, Foam::scalar> scheme
(
    const Foam::fvMesh& mesh
)
{
    using namespace Foam;
    return fv::gaussLaplacianScheme<scalar, scalar>
    (
        mesh,
        tmp<surfaceInterpolationScheme<scalar>>(new linear<scalar>(mesh)),
        tmp<fv::snGradScheme<scalar>>
        (
            new fv::orthogonalSnGrad<scalar>(mesh)
        )
    );
}

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::poissonProblem::random
(
    const labelVector& ijk,
    const label seed
)
{
    const scalar mixed =
        std::sin(12.9898*ijk.x() + 78.233*ijk.y() + 37.719*ijk.z() + seed)
       *43758.5453;
    return mixed - std::floor(mixed);
}


Foam::scalar Foam::fsi::poissonProblem::openPart
(
    const label celli,
    const vector& area,
    const std::function<scalar(const labelVector&, direction)>& open
) const
{
    labelVector high(lattice_.cells()[celli]);
    for (direction d = 0; d < 3; ++d)
    {
        if (mag(area[d]) > 0.5*mag(area))
        {
            high[d] += area[d] > 0 ? 1 : 0;
            return open(high, d);
        }
    }
    return 0;
}


void Foam::fsi::poissonProblem::setSource()
{
    source_ =
        scheme(p_.mesh()).fvcLaplacian(gamma_, exact_)()
      - added_*exact_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::poissonProblem::poissonProblem
(
    latticeMesh& lattice,
    const wordList& fixed,
    const word& fieldName
)
:
    lattice_(lattice),
    singular_(fixed.empty()),
    hasReference_(false),
    reference_(0),
    p_
    (
        IOobject(fieldName, "0", lattice.mesh()),
        lattice.mesh(),
        dimensionedScalar("one", dimless, 1),
        patchTypes(lattice.mesh(), fixed)
    ),
    gamma_
    (
        IOobject("gamma", "0", lattice.mesh()),
        lattice.mesh(),
        dimensionedScalar("one", dimless, 1)
    ),
    exact_("exact", p_),
    source_
    (
        IOobject("source", "0", lattice.mesh()),
        lattice.mesh(),
        dimensionedScalar("zero", dimless/dimArea, 0)
    ),
    added_
    (
        IOobject("added", "0", lattice.mesh()),
        lattice.mesh(),
        dimensionedScalar("zero", dimless/dimArea, 0)
    )
{
    forAll(exact_, celli)
    {
        const labelVector& c = lattice_.cells()[celli];
        exact_[celli] =
            random(c, 1) - 0.5
          + 10*std::sin(0.3*c.x()) + 10*std::cos(0.2*c.y() + 0.1*c.z());
    }
    if (singular_)
    {
        exact_.primitiveFieldRef() -= gAverage(exact_.primitiveField());
    }
    exact_.correctBoundaryConditions();
    setSource();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::poissonProblem::randomCoefficients()
{
    volScalarField cellValue("cellValue", p_);
    forAll(cellValue, celli)
    {
        cellValue[celli] =
            std::pow(10, 2*random(lattice_.cells()[celli], 2) - 1);
    }
    cellValue.correctBoundaryConditions();
    gamma_ = linearInterpolate(cellValue);
    setSource();
}


void Foam::fsi::poissonProblem::mask
(
    const std::function<bool(const labelVector&)>& solid,
    const std::function<scalar(const labelVector&, direction)>& open
)
{
    const fvMesh& mesh = lattice_.mesh();
    volScalarField fluid("fluid", p_);
    forAll(fluid, celli)
    {
        fluid[celli] = solid(lattice_.cells()[celli]) ? 0 : 1;
    }
    fluid.correctBoundaryConditions();
    gamma_ = pos(linearInterpolate(fluid) - 0.75);
    if (open)
    {
        forAll(gamma_, facei)
        {
            gamma_[facei] =
                openPart(mesh.owner()[facei], mesh.Sf()[facei], open);
        }
    }

    // A row without couplings needs a diagonal; walls are none
    for (fvsPatchScalarField& patch : gamma_.boundaryFieldRef())
    {
        forAll(patch, i)
        {
            if (!patch.coupled())
            {
                patch[i] = 0;
            }
            else if (open)
            {
                patch[i] = openPart
                (
                    patch.patch().faceCells()[i], patch.patch().Sf()[i], open
                );
            }
        }
    }
    added_.primitiveFieldRef() =
        neg(fvc::surfaceSum(gamma_)().primitiveField() - SMALL);
    setSource();
}


void Foam::fsi::poissonProblem::setReference(const scalar value)
{
    hasReference_ = true;
    reference_ = value;
}


void Foam::fsi::poissonProblem::addDiagonal(const scalar value)
{
    added_.primitiveFieldRef() += value;
    setSource();
}


Foam::tmp<Foam::fvScalarMatrix> Foam::fsi::poissonProblem::equation()
{
    tmp<fvScalarMatrix> eqn
    (
        scheme(p_.mesh()).fvmLaplacian(gamma_, p_)
      - fvm::Sp(added_, p_)
     == source_
    );
    if (hasReference_)
    {
        eqn.ref().setReference(Pstream::master() ? 0 : -1, reference_);
    }
    return eqn;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::difference(const scalarField& a, const scalarField& b)
{
    return gMax(mag(a - b)())/max(gMax(mag(b)()), VSMALL);
}


// ************************************************************************* //
