// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceCurvature.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceCurvature::updatePlane(const surfaceSet& surfaces)
{
    const pointField& x = surfaces.points();
    const List<surfaceFace>& faces = surfaces.faces();

    vectorField before(x.size(), Zero);
    vectorField behind(x.size(), Zero);
    for (const surfaceFace& f : faces)
    {
        behind[f[0]] = x[f[1]] - x[f[0]];
        before[f[1]] = behind[f[0]];
    }

    // Curvature of the circle through a node and its neighbours
    scalarField curvature(x.size());
    forAll(curvature, i)
    {
        sizes_[i] = 0.5*(mag(before[i]) + mag(behind[i]));
        const scalar lengths =
            mag(before[i])*mag(behind[i])*mag(before[i] + behind[i]);
        curvature[i] = 2*(before[i] ^ behind[i]).z()/max(lengths, VSMALL);
    }
    nodes_ = 0.5*curvature;
    for (const surfaceFace& f : faces)
    {
        nodes_[f[0]] += 0.25*curvature[f[1]];
        nodes_[f[1]] += 0.25*curvature[f[0]];
    }
}


void Foam::fsi::surfaceCurvature::updateSpace(const surfaceSet& surfaces)
{
    const pointField& x = surfaces.points();
    const List<surfaceFace>& faces = surfaces.faces();

    sizes_ = 0;
    normals_.setSize(x.size());
    normals_ = Zero;
    vectorField gradient(x.size(), Zero);
    forAll(faces, facei)
    {
        const surfaceFace& f = faces[facei];
        const vector area(surfaces.areaNormal(facei));
        const vector n(area/max(mag(area), VSMALL));
        for (label i = 0; i < 3; ++i)
        {
            const vector opposite(x[f[(i + 2) % 3]] - x[f[(i + 1) % 3]]);
            gradient[f[i]] += 0.5*(n ^ opposite);
            normals_[f[i]] += area;
            sizes_[f[i]] += mag(area)/3;
        }
    }
    scalarField growth(x.size());
    forAll(growth, i)
    {
        normals_[i] /= max(mag(normals_[i]), VSMALL);
        growth[i] = gradient[i] & normals_[i];
    }

    nodes_ = 0;
    scalarField around(x.size(), Zero);
    for (const surfaceFace& f : faces)
    {
        const scalar growths = growth[f[0]] + growth[f[1]] + growth[f[2]];
        const scalar areas = sizes_[f[0]] + sizes_[f[1]] + sizes_[f[2]];
        for (const label nodei : f)
        {
            nodes_[nodei] += growths;
            around[nodei] += areas;
        }
    }
    nodes_ /= max(around, VSMALL);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::surfaceCurvature::update(const surfaceSet& surfaces)
{
    nodes_.setSize(surfaces.points().size());
    sizes_.setSize(surfaces.points().size());
    faces_.setSize(surfaces.faces().size());
    if (surfaces.nDims() == 2)
    {
        updatePlane(surfaces);
    }
    else
    {
        updateSpace(surfaces);
    }

    const label nNodes = surfaces.nNodes();
    forAll(faces_, facei)
    {
        const surfaceFace& f = surfaces.faces()[facei];
        scalar sum = nodes_[f[0]] + nodes_[f[1]];
        sum += nNodes == 3 ? nodes_[f[2]] : 0;
        faces_[facei] = sum/nNodes;
    }
}


// ************************************************************************* //
