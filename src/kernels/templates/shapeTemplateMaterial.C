// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeTemplate.H"
#include "dictionaryCheck.H"
#include "massPoints.H"
#include "mathematicalConstants.H"
#include "springCalibration.H"

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

    const word strain
    (
        readChoice
        (
            materialDict_,
            "strain",
            "triangle",
            {"triangle", "smoothed"}
        )
    );
    volumeTerm_.reset
    (
        new volumeTerm
        (
            mesh_, thickness_, areaStiffness_, strain == "smoothed"
        )
    );
    referenceVolume_ = sum(volumeTerm_->volumes())/thickness_;
}


void Foam::fsi::shapeTemplate::setSurfaceAlone()
{
    const massPoints body(mesh_, nDims_);
    referenceVolume_ = body.volume();
    nodeMasses_ = body.masses(mass());
}


void Foam::fsi::shapeTemplate::setElasticSprings()
{
    if (shearModulus_ > 0)
    {
        springConstants_.resize(springs_.size());
        springConstants_ = 0;
        return;
    }
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
}


void Foam::fsi::shapeTemplate::setMembrane()
{
    forAll(faces(), i)
    {
        if (faces()[i][0] != i || faces()[i][1] != (i + 1) % faces().size())
        {
            FatalErrorInFunction
                << "The boundary nodes of the membrane " << name_
                << " are not one outline in order" << exit(FatalError);
        }
    }
    springConstants_ =
        membrane_->stretchingModulus*thickness_/restLengths_;
    bending_.reset(new bendingTerm(mesh_, *membrane_, thickness_));
    youngsModulus_ =
        membrane_->stretchingModulus
       /std::sqrt(referenceVolume_/constant::mathematical::pi);
}


void Foam::fsi::shapeTemplate::setMasses()
{
    const word nodeMass
    (
        readChoice
        (
            materialDict_,
            "nodeMass",
            "area",
            {"uniform", "area"}
        )
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


// ************************************************************************* //
