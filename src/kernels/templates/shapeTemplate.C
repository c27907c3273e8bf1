// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
#include "massPoints.H"
#include "stepMatrix.H"
#include "surfaceAlone.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- How many nodes can be held: all, but not the points of mass of a rigid body
static label heldNodesOf(const shapeMesh& mesh)
{
    return mesh.elements.empty() ? mesh.nBoundary : mesh.points.size();
}


//- Lengths of springs as the solver computes them, so that a body at rest has
//  no force [m]
static scalarField lengths
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const direction nDims
)
{
    scalarField lengths(springs.size());
    forAll(springs, springi)
    {
        const vector d =
            mesh.points[springs[springi][1]]
          - mesh.points[springs[springi][0]];
        scalar squares = 0;
        for (label i = 0; i < nDims; ++i)
        {
            squares += d[i]*d[i];
        }
        lengths[springi] = std::sqrt(squares);
    }
    return lengths;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::shapeTemplate::setGeometry()
{
    restLengths_ = lengths(mesh_, springs_, nDims_);
    volumeTerm_ = elastic_->newVolumeTerm(mesh_, thickness_);
    referenceVolume_ = sum(volumeTerm_->volumes())/thickness_;
}


void Foam::fsi::shapeTemplate::checkEntries(const dictionary& dict) const
{
    const bool iterates = elastic_.valid();
    if (iterates)
    {
        elastic_->checkEntries(materialDict_);
    }
    if (!held_.empty() && sheet_.valid())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'hold' in dictionary " << dict.name()
            << " is for elastic and rigid bodies, not for a material of type"
            << " membrane" << exit(FatalIOError);
    }
    if (!iterates && dict.found("admm"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'admm' in dictionary " << dict.name()
            << " has no meaning for a material of type "
            << (rigid_ ? "rigid" : "membrane") << exit(FatalIOError);
    }
    if (rigid_)
    {
        checkKeys(materialDict_, {"type", "density"});
    }
}


void Foam::fsi::shapeTemplate::setMaterial()
{
    springConstants_ = elastic_->springConstants
    (
        mesh_, springs_, *volumeTerm_, thickness_
    );
    nodeMasses_ = elastic_->nodeMasses
    (
        mesh_, *volumeTerm_, thickness_, density_
    );
}


void Foam::fsi::shapeTemplate::setSurfaceAlone()
{
    const massPoints body(mesh_, nDims_);
    referenceVolume_ = body.volume();
    nodeMasses_ =
        sheet_.valid() ? sheetMasses(mesh_, mass()) : body.masses(mass());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shapeTemplate::shapeTemplate
(
    const word& name,
    const dictionary& dict,
    const shapeMesh& mesh,
    const scalar nodeSpacing,
    const scalar thickness,
    const direction nDims,
    const point& origin
)
:
    shapeTemplate
    (
        name, dict, mesh, nodeSpacing, thickness, nDims, true, origin
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
    const bool newMaterial,
    const point& origin
)
:
    name_(name),
    nDims_(nDims),
    thickness_(thickness),
    nodeSpacing_(nodeSpacing),
    materialDict_(dict.subDict("material")),
    density_(readPositive(materialDict_, "density")),
    sheet_(sheetMaterial::New(materialDict_, nDims)),
    rigid_(materialDict_.lookupOrDefault<word>("type", "") == "rigid"),
    elastic_
    (
        rigid_ || sheet_.valid()
      ? nullptr
      : new elasticMaterial(materialDict_, nDims)
    ),
    youngsModulus_(elastic_.valid() ? elastic_->youngsModulus : GREAT),
    admm_
    (
        dict.subOrEmptyDict("admm"),
        nDims,
        dict.subOrEmptyDict("hold").size() > 0
    ),
    mesh_
    (
        rigid_ || sheet_.valid() || mesh.elements.empty()
      ? withoutElements(mesh, nDims, sheet_.valid())
      : mesh
    ),
    springs_(mesh_.edges()),
    held_
    (
        newMaterial
      ? heldNodes
        (
            dict.subOrEmptyDict("hold"),
            SubList<point>(mesh_.points, heldNodesOf(mesh_)),
            origin,
            nDims
        )
      : heldNodes(dict, mesh_.points.size())
    ),
    followed_
    (
        newMaterial
      ? followedNodes
        (
            dict.subOrEmptyDict("follow"),
            SubList<point>(mesh_.points, mesh_.nBoundary),
            origin,
            nDims
        )
      : followedNodes(dict, mesh_.nBoundary)
    )
{
    checkEntries(dict);
    if (elements().empty())
    {
        setSurfaceAlone();
        return;
    }
    setGeometry();
    if (newMaterial)
    {
        setMaterial();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fsi::shapeTemplate::keys()
{
    return {"shape", "mesh", "material", "admm", "hold", "follow"};
}


Foam::scalarField Foam::fsi::shapeTemplate::springWeights
(
    const scalar dt
) const
{
    return admm_.springWeight*law().stiffnessRatio(dt)*springConstants_;
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

    return factors_.get
    (
        dt,
        nBoundaryNodes(),
        [this](const scalar step) { return stepMatrix(*this, step); }
    );
}


// ************************************************************************* //
