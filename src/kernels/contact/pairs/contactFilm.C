// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactFilm.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactFilm::radius
(
    const scalar second,
    const scalar third,
    const scalar depth,
    const direction nDims
) const
{
    const scalar ratio = (nDims == 2 ? 7.0/6 : 4.0/3)*third/second;
    return
        nDims == 2
      ? sqr(15*second/(16*thickness))/(2*depth*pow5(ratio))
      : 3*second/(constant::mathematical::twoPi*depth*pow3(ratio));
}


Foam::scalar Foam::fsi::contactFilm::impulse
(
    const scalar radius,
    const scalar gap,
    const direction nDims
) const
{
    if (!below(gap))
    {
        return 0;
    }
    const scalar factor = 6*constant::mathematical::pi*viscosity;
    return
        nDims == 2
      ? factor*thickness*radius
       *(std::sqrt(2*radius/roughness) - std::sqrt(2*radius/gap))
      : factor*sqr(radius)*std::log(gap/roughness);
}


Foam::scalar Foam::fsi::contactFilm::addedMass(const direction nDims)
{
    // Mirror images without end; zeta(3) is Apery's constant
    const scalar zeta3 = 1.2020569031595943;
    return
        nDims == 2
      ? sqr(constant::mathematical::pi)/3 - 1
      : 1.5*zeta3 - 1;
}


// ************************************************************************* //
