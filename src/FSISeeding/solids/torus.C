// SPDX-License-Identifier: GPL-3.0-or-later

#include "torus.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(torus, 0);
    addToRunTimeSelectionTable(shape, torus, solid);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::torus::torus(const dictionary& dict)
:
    radius_(readPositive(dict, "radius")),
    tubeRadius_(readPositive(dict, "tubeRadius"))
{
    checkKeys(dict, {"type", "radius", "tubeRadius"});
    if (tubeRadius_ >= radius_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'tubeRadius' in dictionary " << dict.name() << " is "
            << tubeRadius_ << " but must be smaller than radius, " << radius_
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::torus::surface() const
{
    // Points along the circle, each with as many around the tube
    const label n = 200, m = 60;
    DynamicList<point> points(n*m);
    DynamicList<surfaceFace> faces(2*n*m);
    for (label i = 0; i < n; ++i)
    {
        const scalar phi = constant::mathematical::twoPi*i/n;
        for (label j = 0; j < m; ++j)
        {
            const scalar theta = constant::mathematical::twoPi*j/m;
            const scalar r = radius_ + tubeRadius_*std::cos(theta);
            points.append
            (
                point
                (
                    r*std::cos(phi),
                    tubeRadius_*std::sin(theta),
                    r*std::sin(phi)
                )
            );
            const label a = m*i + j, b = m*i + (j + 1) % m;
            const label c = (a + m) % (n*m), d = (b + m) % (n*m);
            faces.append(surfaceFace({a, b, c}));
            faces.append(surfaceFace({c, b, d}));
        }
    }
    shapeMesh result;
    result.points = points;
    result.faces = faces;
    result.nBoundary = points.size();
    return result;
}


Foam::scalar Foam::fsi::torus::volume() const
{
    return
        2*sqr(constant::mathematical::pi)*radius_*sqr(tubeRadius_);
}


// ************************************************************************* //
