// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneLaw.H"
#include "dictionaryCheck.H"
#include "laneField.H"
#include "membraneTriangle.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(membraneLaw, 0);
    defineRunTimeSelectionTable(membraneLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::membraneLaw> Foam::fsi::membraneLaw::New
(
    const dictionary& dict
)
{
    return constructorOf
    (
        *dictionaryConstructorTablePtr_,
        dict,
        "law",
        readName(dict, "law", "Skalak")
    )(dict);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::fsi::membraneLaw::readAreaModulus
(
    const dictionary& dict,
    const scalar least
)
{
    const scalar shear = readPositive(dict, "shearModulus");
    const scalar area = readPositive(dict, "areaModulus", 3*shear);
    if (area < least*shear)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'areaModulus' in dictionary " << dict.name() << " is "
            << area << " N/m but must be at least " << least*shear << " N/m, "
            << least << " times the shearModulus, for the law "
            << dict.lookupOrDefault<word>("law", "Skalak")
            << exit(FatalIOError);
    }
    return area/shear;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::membraneLaw::tensions
(
    const UList<scalar>& stretches,
    const UList<scalar>& others
) const
{
    // A triangle with equal sides at rest, one of them across the first
    // stretch. Its tension is the sum of place times force over its area
    const scalar height = std::sqrt(0.75);
    const pointField corners
    ({
        Zero, vector(0, 1, 0), vector(height, 0.5, 0)
    });
    surfaceFace f;
    f[0] = 0;
    f[1] = 1;
    f[2] = 2;
    const List<membraneTriangle> triangle(1, membraneTriangle(f, corners));
    const label atY = 4*nLanes, topX = 6*nLanes, topY = 7*nLanes;

    scalarField result(stretches.size());
    for (label first = 0; first < result.size(); first += nLanes)
    {
        laneField x, force;
        double energy[nLanes] = {};
        x.resize(9*nLanes);
        force.resize(9*nLanes);
        const label n = min(label(nLanes), result.size() - first);
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const label i = first + min(lane, n - 1);
            x[atY + lane] = others[i];
            x[topX + lane] = height*stretches[i];
            x[topY + lane] = 0.5*others[i];
        }
        addForces(triangle, x.data(), force.data(), energy);
        for (label lane = 0; lane < n; ++lane)
        {
            const label i = first + lane;
            result[i] = -2*force[topX + lane]/others[i];
        }
    }
    return result;
}


// ************************************************************************* //
