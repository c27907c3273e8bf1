// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFile.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "surfacePieces.H"
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
    origin_(piece.origin)
{
    checkKeys(dict, {"type", "file", "scale", "cornerAngle", "piece"});
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


Foam::point Foam::fsi::surfaceFile::centroid() const
{
    return
        origin_ + surfaceTools::centroid(surface_.points, surface_.faces);
}


// ************************************************************************* //
