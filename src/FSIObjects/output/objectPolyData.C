// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectPolyData.H"
#include "faceStretches.H"
#include "outlineLoop.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Row of a matrix in the layout of bodyGroup as a vector
static vector row
(
    const Eigen::MatrixXd& rows,
    const label nodei,
    const label copyi,
    const direction nDims,
    const scalar planeZ
)
{
    vector value(0, 0, planeZ);
    for (direction d = 0; d < nDims; ++d)
    {
        value[d] = rows(nodei, nDims*copyi + d);
    }
    return value;
}


//- Values at the nodes of a shape from those of the segments
static scalarField meanOfSegments
(
    const shapeTemplate& shape,
    const scalarField& values
)
{
    scalarField means(values.size(), Zero);
    forAll(values, i)
    {
        means[shape.faces()[i][0]] += 0.5*values[i];
        means[shape.faces()[i][1]] += 0.5*values[i];
    }
    return means;
}


//- Set the larger stretch and tension of the triangles of membranes inside the
//  fluid; in two dimensions those of nodes, the means of their two segments
static void setTensions(polyData& data, const population& objects)
{
    const surfaceSet& surfaces = objects.surfaces();
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (surfaces.hasWalls(objecti))
        {
            continue;
        }
        const shapeTemplate& shape =
            objects.shape(objects.objectGroup(objecti));
        const bool planar = shape.nDims() == 2;
        const auto values = [&](const word& name) -> scalarField&
        {
            return planar ? data.pointScalars(name) : data.cellScalars(name);
        };
        scalarField& stretch = values("stretch");
        scalarField& tension = values("tension");
        const label n =
            planar ? surfaces.points().size() : surfaces.faces().size();
        stretch.resize(n, 1);
        tension.resize(n, 0);
        const membraneLaw& law = *shape.sheet()->law;
        const faceStretches own(objects, objecti);
        scalarField perModulus(law.tensions(own.larger, own.smaller));
        scalarField larger(own.larger);
        label start = surfaces.faceStart()[objecti];
        if (planar)
        {
            start = surfaces.pointStart()[objecti];
            larger = meanOfSegments(shape, larger);
            perModulus = meanOfSegments(shape, perModulus);
        }
        else
        {
            perModulus = max(perModulus, law.tensions(own.smaller, own.larger));
        }
        forAll(perModulus, i)
        {
            stretch[start + i] = larger[i];
            tension[start + i] = law.modulus()*perModulus[i];
        }
    }
}


//- Append the springs of a copy
static void appendSprings
(
    polyData& data,
    const population& objects,
    const label groupi,
    const label copyi,
    label& pointi,
    label& celli
)
{
    const bodyGroup& group = objects.groups()[groupi];
    const shapeTemplate& shape = objects.shape(groupi);
    const direction nDims = objects.nDims();
    const label start = pointi;

    for (label nodei = 0; nodei < shape.nNodes(); ++nodei)
    {
        data.points[pointi] =
            row(group.positions(), nodei, copyi, nDims, objects.planeZ());
        data.pointVectors("velocity")[pointi] =
            row(group.velocities(), nodei, copyi, nDims, 0);
        ++pointi;
    }

    forAll(shape.springs(), springi)
    {
        const edge& spring = shape.springs()[springi];
        const label a = start + spring[0], b = start + spring[1];
        data.cells[celli] = labelList({a, b});
        data.cellLabels("object")[celli] = group.objectIds()[copyi];
        data.cellLabels("shape")[celli] = groupi;
        data.cellScalars("strain")[celli] =
            mag(data.points[b] - data.points[a])
           /shape.restLengths()[springi] - 1;
        ++celli;
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::polyData Foam::fsi::surfacePolyData(const population& objects)
{
    const surfaceSet& surfaces = objects.surfaces();
    const bool planar = surfaces.nDims() == 2;

    polyData data(polyData::POLYGONS);
    data.words("shapeNames") = objects.shapeNames();
    data.points = surfaces.points();
    data.pointVectors("velocity") = surfaces.velocities();

    const label nCells = planar ? surfaces.size() : surfaces.faces().size();
    data.cells.resize(nCells);
    labelList& ids = data.cellLabels("object");
    labelList& shapes = data.cellLabels("shape");
    ids.resize(nCells);
    shapes.resize(nCells);

    for (label celli = 0; celli < nCells; ++celli)
    {
        const label objecti = planar ? celli : surfaces.faceObject()[celli];
        ids[celli] = objects.objectId(objecti);
        shapes[celli] = objects.objectGroup(objecti);
        if (planar)
        {
            data.cells[celli] = outlineLoop(surfaces, objecti);
        }
        else
        {
            data.cells[celli] = labelList(surfaces.faces()[celli]);
        }
    }
    setTensions(data, objects);
    return data;
}


Foam::fsi::polyData Foam::fsi::springPolyData(const population& objects)
{
    label nSprings = 0;
    forAll(objects.groups(), groupi)
    {
        nSprings +=
            objects.groups()[groupi].size()
           *objects.shape(groupi).springs().size();
    }

    polyData data(polyData::LINES);
    data.words("shapeNames") = objects.shapeNames();
    data.points.resize(objects.nNodes());
    data.pointVectors("velocity").resize(objects.nNodes());
    data.cells.resize(nSprings);
    data.cellLabels("object").resize(nSprings);
    data.cellLabels("shape").resize(nSprings);
    data.cellScalars("strain").resize(nSprings);

    label pointi = 0, celli = 0;
    forAll(objects.groups(), groupi)
    {
        for (label i = 0; i < objects.groups()[groupi].size(); ++i)
        {
            appendSprings(data, objects, groupi, i, pointi, celli);
        }
    }
    return data;
}


// ************************************************************************* //
