// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfacePieces.H"
#include "caseFile.H"
#include "dictionaryCheck.H"
#include "DynamicList.H"
#include "noTraps.H"
#include "nullBox.H"
#include "openfoamVersion.H"
#include "OStringStream.H"
#include "surfaceCleaning.H"
#include "surfaceFaults.H"
#include "surfaceTools.H"

#include <cmath>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The polygons of a file in a format that is known
static surfaceFormats::polygonSoup polygonsOf(const caseFile& file)
{
    if (!isIn(surfaceFormats::endings(), word(file.ending(), false)))
    {
        OStringStream os;
        os  << flatOutput(surfaceFormats::endings());
        file.fail
        (
            " cannot be read: valid formats are " + os.str()
          + "; OpenFOAM's surfaceConvert makes one of them from others"
        );
    }
    try
    {
        return surfaceFormats::read(file.ending(), file.text());
    }
    catch (const std::runtime_error& error)
    {
        file.fail(std::string(" cannot be read: ") + error.what());
    }
}


//- Where the coordinates are stored as floats, far from the origin, there is
//  not much left of them
static void checkPrecision(const fileName& file, const boundBox& box)
{
    const scalar size = box.mag();
    const scalar distance = max(mag(box.min()), mag(box.max()));
    if (distance > 100*size)
    {
        WarningInFunction
            << "The surface in " << file.c_str() << " is " << size
            << " large and " << distance << " from the origin: its"
            << " coordinates, of seven digits, are rounded to "
            << 1.2e-7*distance << nl
            << "    Move it to the origin before it is written" << nl << endl;
    }
}


//- Box around the points of the polygons; fatal if there are none
static boundBox boxOf
(
    const caseFile& file,
    const surfaceFormats::polygonSoup& soup
)
{
    boundBox box(nullBox());
    for (const auto& polygon : soup.polygons)
    {
        for (const label l : polygon)
        {
            extend(box, soup.points[l]);
        }
    }
    if (soup.polygons.empty())
    {
        file.fail(": the surface is empty: it has no triangles");
    }
    if (!(box.mag() > 0))
    {
        file.fail(": the surface is a single point");
    }
    return box;
}

//- One of the pieces of a surface, its points alone
static shapeMesh pieceOf
(
    const shapeMesh& all,
    const labelList& pieces,
    const label piece
)
{
    shapeMesh result;
    DynamicList<surfaceFace> faces;
    DynamicList<point> points;
    labelList labels(all.points.size(), -1);
    forAll(all.faces, facei)
    {
        if (pieces[facei] != piece)
        {
            continue;
        }
        surfaceFace face(all.faces[facei]);
        for (label& l : face)
        {
            if (labels[l] < 0)
            {
                labels[l] = points.size();
                points.append(all.points[l]);
            }
            l = labels[l];
        }
        faces.append(face);
    }
    result.points = points;
    result.faces = faces;
    result.nBoundary = result.points.size();
    return result;
}


//- Say how much of a surface was mended, if anything was
static void warn(const caseFile& file, const surfaceCleaning::repairs& done)
{
    if (done.doubled + done.collapsed + done.flat + done.turned)
    {
        WarningInFunction
            << "The surface in " << file.name().c_str() << " was mended: "
            << done.doubled << " triangles that were there twice and "
            << done.collapsed << " without three corners are removed, "
            << done.flat << " without an area have given their place to"
            << " neighbours, " << done.turned << " that faced the other way"
            << " than most are turned" << nl << endl;
    }
}


//- Fatal if a surface, in units of a size about a centre, has a fault; turned
//  round if it is inside out
static void checkSurface
(
    const caseFile& file,
    shapeMesh& surface,
    const point& centre,
    const scalar size
)
{
    const surfaceFault fault(surfaceFaults::first(surface));
    if (fault.text.size())
    {
        OStringStream os;
        os  << ": the surface " << fault.text.c_str() << ", the first at "
            << point(centre + size*fault.place);
        file.fail(os.str());
    }
    if (surfaceTools::volume(surface.points, surface.faces) < 0)
    {
        for (surfaceFace& f : surface.faces)
        {
            Swap(f[1], f[2]);
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Foam::fsi::filePiece> Foam::fsi::readPieces
(
    const dictionary& dict,
    const label piece
)
{
    // CGAL's intervals
    const noTraps untrapped;
    const caseFile file(dict, "file");
    surfaceFormats::polygonSoup soup(polygonsOf(file));
    const boundBox box(boxOf(file, soup));
    if (soup.floats)
    {
        checkPrecision(file.name(), box);
    }

    // Around the origin and about 1 in size, by a power of 2 so that no digit
    // is lost: what follows asks about small differences and powers
    const point centre(centreOf(box));
    const scalar size = std::exp2(std::ceil(std::log2(box.mag())));
    for (point& p : soup.points)
    {
        p = (p - centre)/size;
    }
    shapeMesh all;
    try
    {
        surfaceCleaning::repairs done;
        all = surfaceCleaning::clean(soup, done);
        warn(file, done);
    }
    catch (const std::runtime_error& error)
    {
        file.fail(std::string(" cannot be read: ") + error.what());
    }
    if (all.faces.empty())
    {
        file.fail(": the surface is empty: it has no triangles");
    }
    const labelList pieces(surfaceTools::pieces(all.faces));
    const label n = max(pieces) + 1;
    if (piece > n)
    {
        file.fail
        (
            ": the surface has " + std::to_string(n)
          + " pieces, and none of the number " + std::to_string(piece)
          + " (entry 'piece')"
        );
    }
    const scalar scale = size*readPositive(dict, "scale", 1);
    std::vector<filePiece> result;
    for (label i = 0; i < n; ++i)
    {
        if (piece < 0 || piece == i + 1 || (piece == 0 && i == 0))
        {
            result.push_back
            ({
                piece == 0 ? all : pieceOf(all, pieces, i),
                centre*readPositive(dict, "scale", 1)
            });
            checkSurface(file, result.back().surface, centre, size);
            result.back().surface.points *= scale;
        }
    }
    return result;
}


// ************************************************************************* //
