// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshFiles.H"
#include "errorOf.H"
#include "faceIOList.H"
#include "fileHeaders.H"
#include "labelIOList.H"
#include "meshFaults.H"
#include "openfoamVersion.H"
#include "pointIOField.H"
#include "polyBoundaryMeshEntries.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace meshFiles
{

//- One of the files
static IOobject input
(
    const Time& time,
    const word& region,
    const word& name
)
{
    const fileName folder
    (
        region == polyMesh::defaultRegion
      ? fileName(polyMesh::meshSubDir)
      : fileName(region)/polyMesh::meshSubDir
    );
    return IOobject
    (
        name,
        time.findInstance(folder, name == "points" ? "points" : "faces"),
        folder, time, IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
}


//- FatalError if there is a fault
static void refuse(const IOobject& io, const string& fault)
{
    if (!fault.empty())
    {
        FatalErrorInFunction
            << "File " << pathOf(io) << ": " << fault.c_str() << nl
            << "The mesh is damaged: make it anew, with blockMesh and, for"
            << " ranks, decomposePar" << exit(FatalError);
    }
}


//- Read a file; every error names it
template<class FileType>
static autoPtr<FileType> contentOf(const IOobject& io)
{
    autoPtr<FileType> content;
    const caughtError error =
        errorOf([&]() { content.reset(new FileType(io)); });
    if (!error.message.empty())
    {
        refuse
        (
            io,
            "cannot be read, at line " + Foam::name(error.line) + ": "
          + error.message
        );
    }
    return content;
}


} // End namespace meshFiles
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::meshFiles::check(const Time& time, const word& region)
{
    for
    (
        const fileName& folder :
        {
            time.globalPath()/"system",
            time.globalPath()/caseConstant(time),
            time.path()/time.constant(),
            time.timePath(),
            pathOf(input(time, region, "faces")).path(),
            pathOf(input(time, region, "points")).path()
        }
    )
    {
        fileHeaders::check(folder);
    }

    const auto of = [&](const word& name) { return input(time, region, name); };

    const autoPtr<pointIOField> points(contentOf<pointIOField>(of("points")));
    refuse(of("points"), meshFaults::ofPoints(*points));

    const autoPtr<faceCompactIOList> faces
    (
        contentOf<faceCompactIOList>(of("faces"))
    );
    const label nFaces = faces->size();
    refuse(of("faces"), meshFaults::ofFaces(*faces, points->size()));

    const autoPtr<labelIOList> owner(contentOf<labelIOList>(of("owner")));
    const autoPtr<labelIOList> neighbour
    (
        contentOf<labelIOList>(of("neighbour"))
    );
    refuse(of("owner"), meshFaults::ofLabels(*owner, nFaces));
    refuse(of("neighbour"), meshFaults::ofLabels(*neighbour, nFaces));
    refuse(of("owner"), meshFaults::ofOwners(*owner, *neighbour, nFaces));
    refuse(of("neighbour"), meshFaults::ofNeighbours(*owner, *neighbour));

    const autoPtr<polyBoundaryMeshEntries> patches
    (
        contentOf<polyBoundaryMeshEntries>(of("boundary"))
    );
    refuse
    (
        of("boundary"),
        meshFaults::ofPatches(*patches, neighbour->size(), nFaces)
    );
}


// ************************************************************************* //
