// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFile.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "DynamicList.H"
#include "errorOf.H"
#include "surfacePieces.H"
#include "surfaceTools.H"
#include "Switch.H"
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

//- The entry `piece`, see readPieces
static label pieceNumber(const dictionary& dict)
{
    if (!dict.found("piece"))
    {
        return 0;
    }
    const token value(dict.lookup("piece"));
    if (value.isWord() && value.wordToken() == "all")
    {
        return -1;
    }
    return readAtLeast(dict, "piece", 1, 1);
}


//- The only piece that is asked for
static filePiece readPiece(const dictionary& dict)
{
    const label piece = pieceNumber(dict);
    if (piece < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'piece' in dictionary " << dict.name()
            << " is 'all': there is no single body" << exit(FatalIOError);
    }
    return readPieces(dict, piece)[0];
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceFile::surfaceFile
(
    const dictionary& dict,
    const filePiece& piece
)
:
    cornerAngle_(degToRad(readPositive(dict, "cornerAngle", 40))),
    surface_(piece.surface),
    origin_(piece.origin),
    inside_(readEntryOr<Switch>(dict, "inside", false)),
    wall_(inside_ ? wallOf(surface_) : shapeMesh())
{
    checkKeys
    (
        dict, {"type", "file", "scale", "cornerAngle", "piece", "inside"}
    );
}


Foam::fsi::surfaceFile::surfaceFile(const dictionary& dict)
:
    surfaceFile(dict, readPiece(dict))
{}


Foam::PtrList<Foam::fsi::shape> Foam::fsi::surfaceFile::allPieces
(
    const dictionary& dict
)
{
    PtrList<shape> result;
    if (pieceNumber(dict) < 0)
    {
        for (const filePiece& piece : readPieces(dict, -1))
        {
            result.append(new surfaceFile(dict, piece));
        }
    }
    return result;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::surfaceFile::wallOf(shapeMesh vessel)
{
    for (surfaceFace& f : vessel.faces)
    {
        Swap(f[1], f[2]);
    }
    const boundBox box(vessel.points, false);
    const vector margin(2*box.mag()*vector::one);
    const point corners[2] = {box.min() - margin, box.max() + margin};
    const label n = vessel.points.size();
    DynamicList<point> points(vessel.points);
    for (label i = 0; i < 8; ++i)
    {
        points.append
        (
            point
            (
                corners[i % 2].x(), corners[(i/2) % 2].y(), corners[i/4].z()
            )
        );
    }
    const label sides[6][4] =
    {
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}
    };
    DynamicList<surfaceFace> faces(vessel.faces);
    for (const auto& s : sides)
    {
        faces.append(surfaceFace({n + s[0], n + s[1], n + s[2]}));
        faces.append(surfaceFace({n + s[0], n + s[2], n + s[3]}));
    }
    vessel.points = points;
    vessel.faces = faces;
    vessel.nBoundary = points.size();
    return vessel;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::surfaceFile::surface() const
{
    return surface_;
}


Foam::fsi::shapeMesh Foam::fsi::surfaceFile::mesh
(
    const scalar nodeSpacing,
    const meshGrading& grading,
    const bool filled
) const
{
    if (!inside_)
    {
        return solidShape::mesh(nodeSpacing, grading, filled);
    }
    shapeMesh vessel(solidShape::mesh(nodeSpacing, grading, false));
    vessel.points *= std::cbrt
    (
        surfaceTools::volume(surface_.points, surface_.faces)
       /surfaceTools::volume(vessel.points, vessel.faces)
    );
    shapeMesh wall(wallOf(vessel));
    wall.points -= surfaceTools::centroid(wall.points, wall.faces);
    return wall;
}


Foam::boundBox Foam::fsi::surfaceFile::bounds() const
{
    if (!inside_)
    {
        return solidShape::bounds();
    }
    const point centre(surfaceTools::centroid(wall_.points, wall_.faces));
    return boundBox(pointField(wall_.points - centre), false);
}


Foam::scalar Foam::fsi::surfaceFile::minimumThickness() const
{
    return
        inside_
      ? 2*boundBox(surface_.points, false).mag()
      : solidShape::minimumThickness();
}


Foam::scalar Foam::fsi::surfaceFile::volume() const
{
    return surfaceTools::volume(body().points, body().faces);
}


Foam::scalar Foam::fsi::surfaceFile::cornerAngle() const
{
    return cornerAngle_;
}


Foam::point Foam::fsi::surfaceFile::centroid() const
{
    return origin_ + surfaceTools::centroid(body().points, body().faces);
}


// ************************************************************************* //
