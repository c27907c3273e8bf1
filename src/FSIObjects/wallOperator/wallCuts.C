// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallCuts.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallCuts::update
(
    const interfaceGeometry& geometry,
    const surfaceSet& surfaces
)
{
    nodes_.clear();
    areas_.clear();
    patches_.clear();
    faces_.clear();
    const polyBoundaryMesh& patches =
        geometry.grid().mesh().boundaryMesh();
    const auto add = [&](const label nodei, const wallFace& w, const scalar s)
    {
        vector area(Zero);
        area[w.dir] = (w.lower >= 0 ? s : -s)*w.area;
        nodes_.append(nodei);
        areas_.append(area);
        const label patchi = patches.whichPatch(w.face);
        patches_.append(patchi);
        faces_.append(w.face - patches[patchi].start());
    };
    for (const wallFace& w : geometry.outsideWalls())
    {
        if (w.place.nodes[0] >= 0)
        {
            for (label k = 0; k < 3 && w.place.nodes[k] >= 0; ++k)
            {
                add(w.place.nodes[k], w, w.place.weights[k]);
            }
            continue;
        }
        const label start = surfaces.pointStart()[w.place.object];
        const label end = surfaces.pointStart()[w.place.object + 1];
        for (label nodei = start; nodei < end; ++nodei)
        {
            add(nodei, w, scalar(1)/(end - start));
        }
    }
}


void Foam::fsi::wallCuts::addPressure
(
    const volScalarField& p,
    vectorField& uniform,
    vectorField& load
) const
{
    forAll(nodes_, i)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patches_[i]];
        if (pp.fixesValue())
        {
            uniform[nodes_[i]] -= areas_[i];
            load[nodes_[i]] -= pp[faces_[i]]*areas_[i];
        }
    }
}


void Foam::fsi::wallCuts::addGivenFlux
(
    const volScalarField& p,
    const volVectorField& U,
    const boolList& isFree,
    const vectorField& v,
    const labelList& pointObject,
    scalarField& flux
) const
{
    forAll(nodes_, i)
    {
        if (!p.boundaryField()[patches_[i]].fixesValue())
        {
            const label objecti = pointObject[nodes_[i]];
            flux[objecti] +=
                areas_[i]
              & (
                    isFree[objecti]
                  ? U.boundaryField()[patches_[i]][faces_[i]]
                  : v[nodes_[i]]
                );
        }
    }
}


// ************************************************************************* //
