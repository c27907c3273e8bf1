// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
#include "shape.H"
#include "springCalibration.H"

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
    if (material.found("springLaw"))
    {
        return springLaw::New(material.subDict("springLaw"), E);
    }
    dictionary hookean;
    hookean.add("type", word("Hookean"));
    return springLaw::New(hookean, E);
}


//- Mesh of the shape named in the dictionary
static shapeMesh newMesh
(
    const dictionary& dict,
    const scalar nodeSpacing,
    const direction nDims
)
{
    return shape::New(dict.subDict("shape"), nDims)->mesh(nodeSpacing);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::shapeTemplate::setGeometry()
{
    restLengths_.resize(springs_.size());
    forAll(springs_, springi)
    {
        // As the solver computes lengths, so that a body at rest has no force
        const vector d =
            mesh_.points[springs_[springi].second()]
          - mesh_.points[springs_[springi].first()];
        restLengths_[springi] = std::sqrt(d.x()*d.x() + d.y()*d.y());
    }

    volumeTerm_.reset(new volumeTerm(mesh_, thickness_, areaStiffness_));
    referenceVolume_ = sum(volumeTerm_->volumes())/thickness_;
}


void Foam::fsi::shapeTemplate::setMaterial()
{
    const word calibration
    (
        readChoice
        (
            materialDict_, "calibration", "patch", {"patch", "vanGelder"}
        )
    );
    if (calibration == "patch")
    {
        springConstants_ = springCalibration::calibrated
        (
            mesh_, springs_, *volumeTerm_, thickness_, youngsModulus_
        );
    }
    else
    {
        springConstants_ = youngsModulus_*springCalibration::vanGelder
        (
            mesh_, springs_, volumeTerm_->volumes()
        );
    }

    const word nodeMass
    (
        readChoice(materialDict_, "nodeMass", "area", {"area", "uniform"})
    );
    nodeMasses_.resize(nNodes());
    nodeMasses_ = nodeMass == "uniform" ? mass()/nNodes() : 0;
    if (nodeMass == "area")
    {
        forAll(elements(), elementi)
        {
            for (label i = 0; i < 3; ++i)
            {
                nodeMasses_[elements()[elementi][i]] +=
                    density_*volumeTerm_->volumes()[elementi]/3;
            }
        }
    }
}


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

    volumeTerm_->addLaplacian
    (
        mesh_,
        sqr(dt)*admm_.areaWeight*areaStiffness_,
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
    youngsModulus_(readPositive(materialDict_, "E")),
    areaStiffness_
    (
        readNonNegative(materialDict_, "areaStiffness", 10*youngsModulus_)
    ),
    law_(newLaw(materialDict_, youngsModulus_)),
    admm_(dict.subOrEmptyDict("admm")),
    mesh_(mesh),
    springs_(mesh_.edges()),
    nFactorisations_(0)
{
    checkKeys
    (
        materialDict_,
        {
            "density",
            "E",
            "springLaw",
            "areaStiffness",
            "calibration",
            "nodeMass"
        }
    );
    setGeometry();
    if (newMaterial)
    {
        setMaterial();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fsi::shapeTemplate::keys()
{
    return {"shape", "material", "admm"};
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
