// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshEntries.H"
#include "dictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Labels of all members of a list, one after the other
template<class Labels>
static labelList flatten(const List<Labels>& lists)
{
    labelList flat(lists.size()*Labels().size());
    label next = 0;
    for (const Labels& labels : lists)
    {
        for (const label i : labels)
        {
            flat[next++] = i;
        }
    }
    return flat;
}


//- The inverse of flatten
template<class Labels>
static List<Labels> unflatten(const dictionary& dict, const word& key)
{
    const labelList flat(dict.get<labelList>(key));
    List<Labels> lists(flat.size()/Labels().size());

    label next = 0;
    for (Labels& labels : lists)
    {
        for (label& i : labels)
        {
            i = flat[next++];
        }
    }
    return lists;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::readMesh(const dictionary& dict)
{
    shapeMesh mesh;
    mesh.points = dict.get<pointField>("points");
    mesh.nBoundary = dict.get<label>("nBoundaryNodes");
    mesh.faces = unflatten<surfaceFace>(dict, "faces");
    mesh.elements = unflatten<bodyElement>(dict, "elements");
    return mesh;
}


void Foam::fsi::writeMesh(Ostream& os, const shapeMesh& mesh)
{
    os.writeEntry("nBoundaryNodes", mesh.nBoundary);
    mesh.points.UList<point>::writeEntry("points", os);
    flatten(mesh.faces).writeEntry("faces", os);
    flatten(mesh.elements).writeEntry("elements", os);
}


// ************************************************************************* //
