// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeCheck.H"
#include "dictionaryCheck.H"
#include "shape.H"
#include "sheetMaterial.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Question that is added where the size of a body is absurd
static const char* unitsHint(const bool absurd)
{
    return
        absurd
      ? ". Lengths are in metres: is it in another unit, as millimetres"
        " (entry 'scale' of a shape from a file, 1e-3)?"
      : "";
}


//- Fatal if a body is larger than the domain
static void checkSize
(
    const dictionary& dict,
    const shape& body,
    const seedDomain& domain,
    const bool prescribed
)
{
    const vector span(body.bounds().span());
    const vector room(domain.bounds.span());
    scalar longest = 0, diagonal = 0;
    for (direction d = 0; d < domain.nDims; ++d)
    {
        longest = max(longest, span[d]);
        diagonal += sqr(room[d]);
    }
    const bool absurd = longest > 100*sqrt(diagonal);
    if (absurd || (!prescribed && body.volume() > domain.size()))
    {
        const char* unit = domain.nDims == 2 ? " m2" : " m3";
        FatalIOErrorInFunction(dict)
            << "Entry 'shape' of dictionary " << dict.name()
            << " describes an object of " << body.volume() << unit << ", "
            << longest << " m long, which is more than that of the domain, "
            << domain.size() << unit << ", " << sqrt(diagonal)
            << " m from corner to corner" << unitsHint(absurd)
            << exit(FatalIOError);
    }
}


//- Fatal if a body that moves freely, so may turn, is longer than a period
static void checkPeriod
(
    const dictionary& dict,
    const shape& body,
    const seedDomain& domain
)
{
    const scalar longest = cmptMax(body.bounds().span());
    for (direction d = 0; d < domain.nDims; ++d)
    {
        if (domain.period[d] > 0 && longest >= domain.period[d])
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'shape' of dictionary " << dict.name()
                << " describes an object that is " << longest
                << " m long, but cyclic patches repeat the domain after "
                << domain.period[d] << " m: it would meet its own image" << nl
                << "Take a smaller shape or a longer domain"
                << exit(FatalIOError);
        }
    }
}


//- Fatal if a vessel is not fixed, or its wall does not fill the domain
static void checkVessel
(
    const dictionary& dict,
    const shape& body,
    const seedDomain& domain,
    const word& motion
)
{
    const word material
    (
        dict.subDict("material").lookupOrDefault<word>("type", "")
    );
    if (motion != "fixed" || material != "rigid")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'inside' of the shape in dictionary " << dict.name()
            << " makes it the wall of a vessel, which needs"
            << " 'material { type rigid; ... }' and 'motion { type fixed; }'"
            << exit(FatalIOError);
    }
    const boundBox wall
    (
        body.bounds().min() + body.centroid(),
        body.bounds().max() + body.centroid()
    );
    if (!wall.contains(domain.bounds))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape' of dictionary " << dict.name()
            << " describes a vessel whose wall fills the box " << wall
            << " m, but the domain is " << domain.bounds << " m: is the"
            << " domain too large, or 'scale' wrong?" << exit(FatalIOError);
    }
}


//- The least thickness. Fatal if a body is thinner than minimumCells cells, or
//  lost among nodes
static scalar checkThickness
(
    const dictionary& dict,
    const shape& body,
    const seedDomain& domain
)
{
    const scalar cells = minimumCells(dict);
    const scalar least = cells*domain.spacing;
    const scalar thickness = body.minimumThickness();
    if (thickness < least)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape' of dictionary " << dict.name()
            << " describes an object that is " << thickness
            << " m thick at its thinnest, which is less than " << cells
            << " cells, " << least << " m (entry 'minimumCells')"
            << unitsHint(body.bounds().mag() < 0.01*least) << nl
            << "Take a finer mesh or a larger shape; a smaller minimumCells"
            << " is at your own risk"
            << exit(FatalIOError);
    }

    // The mesh's surface is up to a ninth of the distance of nodes off
    const scalar nodeSpacing =
        readPositive(dict, "nodeSpacing", domain.spacing);
    if (domain.nDims == 3 && thickness < 0.2*nodeSpacing)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape' of dictionary " << dict.name()
            << " describes an object that is " << thickness
            << " m thick at its thinnest: it cannot be meshed with nodes "
            << nodeSpacing << " m apart (entry 'nodeSpacing')" << nl
            << "Take a finer mesh or a larger shape" << exit(FatalIOError);
    }
    return thickness;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::minimumCells(const dictionary& dict)
{
    const bool immersed = sheetMaterial::chosen(dict.subDict("material"));
    return readNonNegative(dict, "minimumCells", immersed ? 1 : 3);
}


Foam::scalar Foam::fsi::checkShape
(
    const dictionary& dict,
    const shape& body,
    const seedDomain& domain
)
{
    const word motion
    (
        dict.subOrEmptyDict("motion").lookupOrDefault<word>("type", "free")
    );
    if (body.hollow())
    {
        checkVessel(dict, body, domain, motion);
    }
    else
    {
        checkSize(dict, body, domain, motion != "free");
        if (motion == "free" && !dict.found("hold"))
        {
            checkPeriod(dict, body, domain);
        }
    }
    return checkThickness(dict, body, domain);
}


// ************************************************************************* //
