// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
#include "elasticMaterial.H"
#include "elementViscosity.H"
#include "newShapeMesh.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Number of factors kept
static const std::size_t nKeptFactors = 4;

//- The sub-dictionary of the spring law; Hookean if there is none
static autoPtr<springLaw> newLaw(const dictionary& material, const scalar E)
{
    checkSubDicts(material, {"springLaw"});
    if (material.found("springLaw"))
    {
        return springLaw::New(material.subDict("springLaw"), E);
    }
    dictionary hookean;
    hookean.add("type", word("Hookean"));
    return springLaw::New(hookean, E);
}


//- The material of a membrane; null for an elastic body
static autoPtr<membraneMaterial> newMembrane(const dictionary& material)
{
    return autoPtr<membraneMaterial>
    (
        membraneMaterial::chosen(material)
      ? new membraneMaterial(material)
      : nullptr
    );
}


//- Springs of an elastic body lie on all edges, of a membrane on its boundary
static edgeList newSprings(const shapeMesh& mesh, const bool membrane)
{
    if (!membrane)
    {
        return mesh.edges();
    }
    edgeList springs(mesh.faces.size());
    forAll(springs, i)
    {
        springs[i] = edge(mesh.faces[i][0], mesh.faces[i][1]);
    }
    return springs;
}


//- Mesh of the shape named in the dictionary
static shapeMesh newMesh
(
    const dictionary& dict,
    const scalar nodeSpacing,
    const direction nDims
)
{
    return newShapeMesh
    (
        dict.subDict("shape"),
        nDims,
        nodeSpacing,
        meshGrading(dict.subOrEmptyDict("mesh")),
        true
    );
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::SparseMatrix<double> Foam::fsi::shapeTemplate::matrix
(
    const scalar dt
) const
{
    std::vector<Eigen::Triplet<double>> entries;

    forAll(nodeMasses_, nodei)
    {
        entries.emplace_back(nodei, nodei, nodeMasses_[nodei]);
    }

    const scalarField weights(sqr(dt)*springWeights(dt));
    forAll(springs_, springi)
    {
        const label a = springs_[springi].first();
        const label b = springs_[springi].second();
        entries.emplace_back(a, a, weights[springi]);
        entries.emplace_back(b, b, weights[springi]);
        entries.emplace_back(a, b, -weights[springi]);
        entries.emplace_back(b, a, -weights[springi]);
    }

    const volumeTerm& term = *volumeTerm_;
    term.areaDomains().addLaplacian
    (
        sqr(dt)*admm_.areaWeight*areaStiffness_,
        entries
    );
    term.shearDomains().addLaplacian
    (
        2*sqr(dt)*shearModulus_ + dt*elementViscosity::boundRatio*viscosity_,
        entries
    );

    Eigen::SparseMatrix<double> matrix(nNodes(), nNodes());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shapeTemplate::shapeTemplate
(
    const word& name,
    const dictionary& dict,
    const shapeMesh& mesh,
    const scalar nodeSpacing,
    const scalar thickness,
    const direction nDims
)
:
    shapeTemplate(name, dict, mesh, nodeSpacing, thickness, nDims, true)
{}


Foam::fsi::shapeTemplate::shapeTemplate
(
    const word& name,
    const dictionary& dict,
    const scalar nodeSpacing,
    const scalar thickness,
    const direction nDims
)
:
    shapeTemplate
    (
        name,
        dict,
        newMesh(dict, nodeSpacing, nDims),
        nodeSpacing,
        thickness,
        nDims,
        true
    )
{}


Foam::fsi::shapeTemplate::shapeTemplate
(
    const word& name,
    const dictionary& dict,
    const shapeMesh& mesh,
    const scalar nodeSpacing,
    const scalar thickness,
    const direction nDims,
    const bool newMaterial
)
:
    name_(name),
    nDims_(nDims),
    thickness_(thickness),
    nodeSpacing_(nodeSpacing),
    materialDict_(dict.subDict("material")),
    density_(readPositive(materialDict_, "density")),
    membrane_(newMembrane(materialDict_)),
    youngsModulus_
    (
        membrane_.valid() ? 0 : readPositive(materialDict_, "E")
    ),
    areaStiffness_
    (
        readNonNegative(materialDict_, "areaStiffness", 10*youngsModulus_)
    ),
    shearModulus_
    (
        elasticMaterial::shearModulus
        (
            materialDict_, youngsModulus_, areaStiffness_
        )
    ),
    viscosity_(elasticMaterial::viscosity(materialDict_, areaStiffness_)),
    law_(newLaw(materialDict_, youngsModulus_)),
    admm_(dict.subOrEmptyDict("admm")),
    mesh_(mesh),
    springs_(newSprings(mesh_, membrane_.valid())),
    nFactorisations_(0)
{
    elasticMaterial::check(dict, membrane_.valid());
    setGeometry();
    if (membrane_.valid())
    {
        setMembrane();
    }
    if (newMaterial)
    {
        if (!membrane_.valid())
        {
            setElasticSprings();
        }
        setMasses();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fsi::shapeTemplate::keys()
{
    return {"shape", "mesh", "material", "admm"};
}


Foam::scalarField Foam::fsi::shapeTemplate::springWeights
(
    const scalar dt
) const
{
    return admm_.springWeight*law_->stiffnessRatio(dt)*springConstants_;
}


const Foam::fsi::admmFactor& Foam::fsi::shapeTemplate::factor
(
    const scalar dt
) const
{
    if (!(dt > 0) || dt > GREAT)
    {
        FatalErrorInFunction
            << "Time step " << dt << " s of shape " << name_
            << " must be > 0" << exit(FatalError);
    }

    if (membrane_.valid())
    {
        FatalErrorInFunction
            << "Shape " << name_ << " is a membrane: its copies have matrices"
            << " of their own" << exit(FatalError);
    }

    auto found = std::find_if
    (
        factors_.begin(),
        factors_.end(),
        [dt](const auto& f) { return f->deltaT() == dt; }
    );
    if (found == factors_.end())
    {
        factors_.push_back
        (
            std::make_unique<admmFactor>(matrix(dt), nBoundaryNodes(), dt)
        );
        ++nFactorisations_;
        found = std::prev(factors_.end());
    }

    std::rotate(factors_.begin(), found, std::next(found));
    if (factors_.size() > nKeptFactors)
    {
        factors_.pop_back();
    }
    return *factors_.front();
}


// ************************************************************************* //
