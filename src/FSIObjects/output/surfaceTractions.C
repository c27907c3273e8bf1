// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceTractions.H"
#include "gatheredObjects.H"

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
    const vectorField values
    (
        tractions(objects.surfaces(), objects.size(), force, thickness)
    );
    List<vectorField> mine(objects.size());
    forAll(mine, objecti)
    {
        const label n = start[objecti + 1] - start[objecti];
        mine[objecti] = SubField<vector>(values, n, start[objecti]);
    }
    const List<vectorField> ofObjects
    (
        gatheredObjects
        (
            objects,
            mine,
            [&](copyValues& sent, vectorField& nodal, const label groupi)
            {
                nodal.setSize(objects.shape(groupi).nBoundaryNodes());
                for (vector& value : nodal)
                {
                    sent.vectorOf(value);
                }
            }
        )
    );
    DynamicList<vector> all;
    for (const vectorField& nodal : ofObjects)
    {
        all.append(nodal);
    }
    return vectorField(all);
}


// ************************************************************************* //
