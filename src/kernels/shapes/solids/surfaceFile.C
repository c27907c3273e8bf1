// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFile.H"
#include "addToRunTimeSelectionTable.H"
#include "boundBox.H"
#include "caseFile.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "mergePoints.H"
#include "openfoamSurface.H"
#include "OSspecific.H"
#include "surfaceFaults.H"
#include "surfaceTools.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(surfaceFile, 0);
    addToRunTimeSelectionTable(shape, surfaceFile, solid);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The triangles with each place a single point, all of them used
static shapeMesh joined(const triSurface& triangles)
{
    const pointField& all = triangles.points();
    labelList places;
    pointField points;
    mergePoints
    (
        all, 1e-8*boundBox(all, false).mag(), false, places, points
    );

    shapeMesh result;
    labelList labels(points.size(), -1);
    for (const labelledTri& t : triangles)
    {
        surfaceFace face;
        for (label i = 0; i < 3; ++i)
        {
            label& l = labels[places[t[i]]];
            if (l < 0)
            {
                l = result.nBoundary++;
            }
            face[i] = l;
        }
        result.faces.append(face);
    }
    result.points.resize(result.nBoundary);
    forAll(points, i)
    {
        if (labels[i] >= 0)
        {
            result.points[labels[i]] = points[i];
        }
    }
    return result;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceFile::fail
(
    const dictionary& dict,
    const fileName& file,
    const string& reason
)
{
    FatalIOErrorInFunction(dict)
        << "Entry 'file' in dictionary " << dict.name()
        << ": the surface in " << file << ' ' << reason.c_str()
        << exit(FatalIOError);
}


Foam::fsi::shapeMesh Foam::fsi::surfaceFile::read(const dictionary& dict)
{
    const fileName file(readCaseFile(dict, "file"));
    if (!isFile(file))
    {
        fail(dict, file, "cannot be read: there is no such file");
    }
    if (!canReadSurface(file))
    {
        OStringStream os;
        os  << "cannot be read: valid formats are "
            << flatOutput(surfaceFormats());
        fail(dict, file, os.str());
    }

    triSurface triangles;
    const caughtError error
    (
        errorOf([&]() { triangles = triSurface(file); })
    );
    if (error.message.size())
    {
        fail(dict, file, "cannot be read: " + error.message);
    }
    for (const point& p : triangles.points())
    {
        if (!isUsable(p))
        {
            // OpenFOAM's reader makes floats, too small for some numbers
            fail(dict, file, "has a coordinate that is no number below 1e15");
        }
    }
    if (triangles.empty())
    {
        fail(dict, file, "is empty: it has no triangles");
    }

    shapeMesh result(joined(triangles));
    const string fault(surfaceFaults::first(result));
    if (fault.size())
    {
        fail(dict, file, fault);
    }
    if (surfaceTools::volume(result.points, result.faces) < 0)
    {
        for (surfaceFace& f : result.faces)
        {
            Swap(f[1], f[2]);
        }
    }
    result.points *= readPositive(dict, "scale", 1);
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceFile::surfaceFile(const dictionary& dict)
:
    cornerAngle_(degToRad(readPositive(dict, "cornerAngle", 40))),
    surface_(read(dict))
{
    checkKeys(dict, {"type", "file", "scale", "cornerAngle"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::surfaceFile::surface() const
{
    return surface_;
}


Foam::scalar Foam::fsi::surfaceFile::volume() const
{
    return surfaceTools::volume(surface_.points, surface_.faces);
}


Foam::scalar Foam::fsi::surfaceFile::cornerAngle() const
{
    return cornerAngle_;
}


// ************************************************************************* //
