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
    largestPull_(readNonNegative(dict, "pull", 0.1)*scales.youngsModulus),
    factor_(0)
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::ReynoldsLubrication::setCurvatures(const surfaceSet& surfaces)
{
    const pointField& x = surfaces.points();
    const List<surfaceFace>& faces = surfaces.faces();

    vectorField before(x.size(), Zero);
    vectorField behind(x.size(), Zero);
    for (const surfaceFace& f : faces)
    {
        behind[f[0]] = x[f[1]] - x[f[0]];
        before[f[1]] = behind[f[0]];
    }

    // Of the circle through a node and its neighbours
    scalarField curvature(x.size());
    forAll(curvature, i)
    {
        nodeLengths_[i] = 0.5*(mag(before[i]) + mag(behind[i]));
        const scalar lengths =
            mag(before[i])*mag(behind[i])*mag(before[i] + behind[i]);
        curvature[i] = 2*(before[i] ^ behind[i]).z()/max(lengths, VSMALL);
    }
    nodeCurvatures_ = 0.5*curvature;
    for (const surfaceFace& f : faces)
    {
        nodeCurvatures_[f[0]] += 0.25*curvature[f[1]];
        nodeCurvatures_[f[1]] += 0.25*curvature[f[0]];
    }
    forAll(faces, facei)
    {
        const surfaceFace& f = faces[facei];
        faceCurvatures_[facei] =
            0.5*(nodeCurvatures_[f[0]] + nodeCurvatures_[f[1]]);
    }
}


void Foam::fsi::ReynoldsLubrication::update(const surfaceSet& surfaces)
{
    const bool planar = surfaces.nDims() == 2;
    const scalar pi = constant::mathematical::pi;

    factor_ = (planar ? 6 : 3)*viscosity_;
    curvatures_.setSize(surfaces.size());
    forAll(curvatures_, objecti)
    {
        const scalar area = surfaces.surfaceArea(objecti);
        curvatures_[objecti] = planar ? 2*pi/area : sqrt(4*pi/area);
    }
    nodeCurvatures_.setSize(surfaces.points().size());
    nodeCurvatures_ = 0;
    faceCurvatures_.setSize(surfaces.faces().size());
    faceCurvatures_ = 0;
    nodeLengths_.setSize(surfaces.points().size());
    nodeLengths_ = 0;
    if (planar)
    {
        setCurvatures(surfaces);
    }
}


Foam::scalar Foam::fsi::ReynoldsLubrication::resistance
(
    const label objecti,
    const contactPair& pair
) const
{
    const bool wall = pair.face < 0;
    const scalar bodies =
        curvatures_[objecti] + (wall ? 0 : curvatures_[pair.other]);
    const scalar place =
        nodeCurvatures_[pair.node] + (wall ? 0 : faceCurvatures_[pair.face]);
    const scalar R = 1/max(bodies, place);

    // Of a film that is shorter than its node's share of the surface, what
    // there is of it
    const scalar width = Foam::sqrt(2*R*max(pair.gap, roughness_));
    const scalar share = 0.5*nodeLengths_[pair.node]/width;
    const scalar part =
        share < 1e-3
      ? 1
      : 0.5/(1 + sqr(share)) + 0.5*Foam::atan(share)/share;
    return factor_*R*part;
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
