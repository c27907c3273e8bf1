// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceTractions.H"
#include "copyValues.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Tractions at the surface nodes of a rank's own objects [Pa]
static vectorField tractions
(
    const surfaceSet& surfaces,
    const label nObjects,
    const vectorField& force,
    const scalar thickness
)
{
    const label nNodes = surfaces.pointStart()[nObjects];
    scalarField area(nNodes, Zero);
    for (label facei = 0; facei < surfaces.faceStart()[nObjects]; ++facei)
    {
        const scalar part =
            mag(surfaces.areaNormal(facei))*thickness/surfaces.nNodes();
        for (label i = 0; i < surfaces.nNodes(); ++i)
        {
            area[surfaces.faces()[facei][i]] += part;
        }
    }
    vectorField values(nNodes);
    forAll(values, nodei)
    {
        values[nodei] = force[nodei]/area[nodei];
    }
    return values;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::fsi::gatheredTractions
(
    const population& objects,
    const vectorField& force,
    const scalar thickness
)
{
    const labelList& start = objects.surfaces().pointStart();
    vectorField mine
    (
        tractions(objects.surfaces(), objects.size(), force, thickness)
    );
    if (objects.ranks().shared())
    {
        return mine;
    }
    copyValues sent;
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        label groupi = objects.objectGroup(objecti);
        label id = objects.objectId(objecti);
        sent.number(groupi);
        sent.number(id);
        for (label i = start[objecti]; i < start[objecti + 1]; ++i)
        {
            sent.vectorOf(mine[i]);
        }
    }
    copyValues received
    (
        objects.ranks().gathered(scalarList(sent.values()), false)
    );
    std::map<labelPair, vectorField> sorted;
    label nNodes = 0;
    while (received.more())
    {
        labelPair key;
        received.number(key.first());
        received.number(key.second());
        vectorField& values = sorted[key];
        values.setSize(objects.shape(key.first()).nBoundaryNodes());
        nNodes += values.size();
        for (vector& value : values)
        {
            received.vectorOf(value);
        }
    }
    vectorField all(nNodes);
    label next = 0;
    for (const auto& each : sorted)
    {
        for (const vector& value : each.second)
        {
            all[next++] = value;
        }
    }
    return all;
}


// ************************************************************************* //
