// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape.H"
#include "mathematicalConstants.H"
#include "outlineTools.H"
#include "triangulation.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(shape, 0);
    defineRunTimeSelectionTable(shape, dictionary);
}
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::shape> Foam::fsi::shape::New
(
    const dictionary& dict,
    const direction nDims
)
{
    const word shapeType(dict.get<word>("type"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(shapeType);
    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown entry 'type' " << shapeType << " in dictionary "
            << dict.name() << nl << "Valid shapes are "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }
    if (nDims != 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' " << shapeType << " in dictionary " << dict.name()
            << " is an outline in two dimensions, but the case has "
            << label(nDims) << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::fsi::shape::sample
(
    const std::function<point(scalar)>& curve
)
{
    const label n = 16384;
    pointField points(n);
    forAll(points, i)
    {
        points[i] = curve(constant::mathematical::twoPi*i/n);
    }
    return points;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::shape::cornerAngle() const
{
    return degToRad(20.0);
}


Foam::pointField Foam::fsi::shape::outline(const scalar nodeSpacing) const
{
    const pointField fine(outlineTools::counterClockwise(curve()));
    pointField points
    (
        outlineTools::resample(fine, nodeSpacing, cornerAngle())
    );
    points -= outlineTools::centroid(points);
    points *=
        std::sqrt(outlineTools::area(fine)/outlineTools::area(points));
    return points;
}


Foam::fsi::shapeMesh Foam::fsi::shape::mesh
(
    const scalar nodeSpacing,
    const meshGrading& grading
) const
{
    return triangulation::mesh(outline(nodeSpacing), nodeSpacing, grading);
}


Foam::scalar Foam::fsi::shape::minimumThickness() const
{
    // Three hundred nodes around the body show any neck worth meshing
    const pointField fine(outlineTools::counterClockwise(curve()));
    return outlineTools::minimumThickness
    (
        outlineTools::resample
        (
            fine,
            outlineTools::perimeter(fine)/300,
            cornerAngle()
        )
    );
}


// ************************************************************************* //
