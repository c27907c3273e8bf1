// SPDX-License-Identifier: GPL-3.0-or-later

#include "rectangle.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(rectangle, 0);
    addToRunTimeSelectionTable(shape, rectangle, planar);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rectangle::rectangle(const dictionary& dict)
:
    length_(readPositive(dict, "length")),
    width_(readPositive(dict, "width")),
    edgeRadius_(readNonNegative(dict, "edgeRadius", 0))
{
    checkKeys(dict, {"type", "length", "width", "edgeRadius"});
    const scalar most = 0.5*min(length_, width_);
    if (edgeRadius_ > most*(1 + 1e-9))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'edgeRadius' in dictionary " << dict.name() << " is "
            << edgeRadius_ << " but must be at most " << most << ", half of the"
            << " smaller extent" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsi::rectangle::curve() const
{
    const label n = edgeRadius_ > 0 ? 64 : 0;
    const vector middle
    (
        max(0.5*length_ - edgeRadius_, scalar(0)),
        max(0.5*width_ - edgeRadius_, scalar(0)),
        0
    );
    const scalar same = 1e-6*min(length_, width_);
    DynamicList<point> points;
    for (label corner = 0; corner < 4; ++corner)
    {
        const vector side(corner % 3 == 0 ? 1 : -1, corner < 2 ? 1 : -1, 0);
        for (label i = 0; i <= n; ++i)
        {
            const scalar angle =
                constant::mathematical::piByTwo*(corner + scalar(i)/max(n, 1));
            const point p
            (
                cmptMultiply(side, middle)
              + edgeRadius_*vector(std::cos(angle), std::sin(angle), 0)
            );
            if (points.empty() || mag(p - points.last()) > same)
            {
                points.append(p);
            }
        }
    }
    if (mag(points.last() - points[0]) <= same)
    {
        points.setSize(points.size() - 1);
    }
    return pointField(points);
}


// ************************************************************************* //
