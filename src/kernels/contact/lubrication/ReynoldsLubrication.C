// SPDX-License-Identifier: GPL-3.0-or-later

#include "ReynoldsLubrication.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(ReynoldsLubrication, 0);
    addToRunTimeSelectionTable(lubrication, ReynoldsLubrication, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::ReynoldsLubrication::ReynoldsLubrication
(
    const dictionary& dict,
    const contactScales& scales
)
:
    viscosity_
    (
        scales.viscosity > 0
      ? readPositive(dict, "viscosity", scales.viscosity)
      : readPositive(dict, "viscosity")
    ),
    cutOff_(readPositive(dict, "cutOff", 1)*scales.spacing),
    roughness_(readPositive(dict, "roughness", 0.01)*scales.spacing),
    largestPull_
    (
        scales.youngsModulus > 0
      ? readNonNegative(dict, "pull", 0.1)*scales.youngsModulus
      : GREAT
    ),
    surfaces_(nullptr)
{
    checkKeys(dict, {"type", "viscosity", "cutOff", "roughness", "pull"});
    if (cutOff_ > scales.range || roughness_ >= cutOff_)
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'cutOff' and 'roughness' in dictionary " << dict.name()
            << " give the gaps " << cutOff_ << " and " << roughness_
            << " m but must be in this order: roughness below cutOff, cutOff"
            << " at most the range of contact, " << scales.range << " m"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::ReynoldsLubrication::lengthPart
(
    const contactPair& pair,
    const scalar curvature
) const
{
    const scalar width = Foam::sqrt(2/curvature*max(pair.gap, roughness_));
    const scalar share = 0.5*surface_.size(pair.node)/width;
    return
        share < 1e-3
      ? 1
      : 0.5/(1 + sqr(share)) + 0.5*Foam::atan(share)/share;
}


Foam::scalar Foam::fsi::ReynoldsLubrication::areaPart
(
    const contactPair& pair,
    const scalar curvature
) const
{
    // The gap opens with the angle between the surfaces
    vector apart(surface_.normals()[pair.node]);
    apart +=
        pair.wall >= 0
      ? pair.normal
      : surfaces_->interpolate(surface_.normals(), pair.face, pair.weights);

    const scalar gap = max(pair.gap, roughness_);
    const scalar least = max
    (
        gap - magSqr(apart)/curvature, max(0.25*gap, roughness_)
    );
    const scalar widthSqr = 4*least/curvature;
    const scalar awaySqr = (gap - least)/least;
    const scalar share =
        surface_.size(pair.node)/(constant::mathematical::pi*widthSqr);
    const scalar x = 1 + awaySqr - share;

    // 1 - x/root without its cancellation
    const scalar root = Foam::sqrt(sqr(x) + 4*share);
    const scalar rest =
        x > 0 ? 4*share/(root*(root + x)) : 1 - x/root;
    return 0.5*rest/share*sqr(gap/least);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::ReynoldsLubrication::update(const surfaceSet& surfaces)
{
    const scalar pi = constant::mathematical::pi;

    surfaces_ = &surfaces;
    curvatures_.setSize(surfaces.size());
    forAll(curvatures_, objecti)
    {
        const scalar area = surfaces.surfaceArea(objecti);
        curvatures_[objecti] =
            surfaces.nDims() == 2 ? 2*pi/area : 2*Foam::sqrt(4*pi/area);
    }
    surface_.update(surfaces);
}


Foam::scalar Foam::fsi::ReynoldsLubrication::resistance
(
    const label objecti,
    const contactPair& pair
) const
{
    if (inFlow(objecti, pair))
    {
        return 0;
    }
    const bool wall = pair.wall >= 0;
    const scalar bodies =
        curvatures_[objecti] + (wall ? 0 : curvatures_[pair.other]);
    const scalar place =
        surface_.node(pair.node) + (wall ? 0 : surface_.face(pair.face));
    const scalar curvature = max(bodies, place);
    const scalar part =
        surfaces_->nDims() == 2
      ? lengthPart(pair, curvature)
      : areaPart(pair, curvature);
    return 6*viscosity_*(1/curvature)*part;
}


Foam::scalar Foam::fsi::ReynoldsLubrication::psi(const scalar gap) const
{
    const scalar g = min(max(gap, roughness_), cutOff_);
    return
        1/cutOff_ - 1/g + (cutOff_ - g)/sqr(cutOff_)
      + min(gap - g, 0.0)*psiSlope(roughness_);
}


Foam::scalar Foam::fsi::ReynoldsLubrication::psiSlope(const scalar gap) const
{
    const scalar g = min(max(gap, roughness_), cutOff_);
    return 1/sqr(g) - 1/sqr(cutOff_);
}


// ************************************************************************* //
