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
    factor_(0)
{
    checkKeys(dict, {"type", "viscosity", "cutOff", "roughness"});
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
}


Foam::scalar Foam::fsi::ReynoldsLubrication::resistance
(
    const label objecti,
    const contactPair& pair
) const
{
    return
        factor_
       /(curvatures_[objecti] + (pair.other < 0 ? 0 : curvatures_[pair.other]));
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
