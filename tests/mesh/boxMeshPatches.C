// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Name of a side of the box: xMin, xMax, ...
Foam::word sideName(const Foam::direction dir, const int side)
{
    static const char* names[3][2] =
    {
        {"xMin", "xMax"}, {"yMin", "yMax"}, {"zMin", "zMax"}
    };
    return names[dir][side];
}

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::boxMesh::addSide
(
    const direction dir,
    const int side,
    DynamicList<face>& faces,
    DynamicList<label>& owner
) const
{
    labelVector low(labelVector::zero);
    labelVector high(n_);
    low[dir] = (side == 0 ? 0 : n_[dir] - 1);
    high[dir] = low[dir] + 1;

    labelVector ijk;
    for (ijk.z() = low.z(); ijk.z() < high.z(); ++ijk.z())
    {
        for (ijk.y() = low.y(); ijk.y() < high.y(); ++ijk.y())
        {
            for (ijk.x() = low.x(); ijk.x() < high.x(); ++ijk.x())
            {
                faces.append(cellFace(ijk, dir, side));
                owner.append(cell(ijk));
            }
        }
    }
}


bool Foam::fsi::boxMesh::isShared(const direction dir, const int side) const
{
    if (dir != layout_.splitDirection || Pstream::nProcs() == 1)
    {
        return false;
    }
    const label outermost = (side == 0 ? 0 : Pstream::nProcs() - 1);
    return layout_.cyclic[dir] || Pstream::myProcNo() != outermost;
}


Foam::dictionary Foam::fsi::boxMesh::outerPatch
(
    const direction dir,
    const int side
) const
{
    dictionary dict;
    if (layout_.cyclic[dir])
    {
        vector separation(Zero);
        separation[dir] = layout_.spacing*nAll_[dir]*(side == 0 ? 1 : -1);

        dict.add("type", word("cyclic"));
        dict.add("neighbourPatch", sideName(dir, 1 - side));
        dict.add("transform", word("translational"));
        dict.add("separationVector", separation);
        // The Foundation's separation has the other sign
        dict.add("transformType", word("translational"));
        dict.add("separation", vector(-separation));
    }
    else
    {
        dict.add("type", word("wall"));
    }
    return dict;
}


Foam::word Foam::fsi::boxMesh::addSharedPatch
(
    const int side,
    dictionary& dict
) const
{
    const label nProcs = Pstream::nProcs();
    const label me = Pstream::myProcNo();
    const label other = (me + (side == 0 ? nProcs - 1 : 1)) % nProcs;
    const bool isOutermost = (me == (side == 0 ? 0 : nProcs - 1));

    word patchName("procBoundary" + Foam::name(me) + "to" + Foam::name(other));
    dict.add("type", word("processor"));
    if (isOutermost)
    {
        const word refer(sideName(layout_.splitDirection, side));
        patchName += "through" + refer;
        dict.set("type", word("processorCyclic"));
        dict.add("referPatch", refer);
    }
    dict.add("myProcNo", me);
    dict.add("neighbProcNo", other);
    return patchName;
}


Foam::dictionary Foam::fsi::boxMesh::addBoundary
(
    DynamicList<face>& faces,
    DynamicList<label>& owner
) const
{
    dictionary patches;
    auto append = [&](const word& patchName, dictionary dict, label start)
    {
        dict.add("startFace", start);
        dict.add("nFaces", faces.size() - start);
        patches.add(patchName, dict);
    };

    for (direction dir = 0; dir < nDims_; ++dir)
    {
        for (int side = 0; side < 2; ++side)
        {
            const label start = faces.size();
            if (!isShared(dir, side))
            {
                addSide(dir, side, faces, owner);
            }
            append(sideName(dir, side), outerPatch(dir, side), start);
        }
    }

    if (nDims_ == 2)
    {
        const label start = faces.size();
        addSide(vector::Z, 0, faces, owner);
        addSide(vector::Z, 1, faces, owner);
        dictionary dict;
        dict.add("type", word("empty"));
        append("frontAndBack", dict, start);
    }

    // Processor patches come last, those through a cyclic after the others:
    // two ranks that share two patches need the same order
    const int first = Pstream::master() ? 1 : 0;
    for (const int side : {first, 1 - first})
    {
        if (isShared(layout_.splitDirection, side))
        {
            const label start = faces.size();
            addSide(layout_.splitDirection, side, faces, owner);
            dictionary dict;
            const word patchName(addSharedPatch(side, dict));
            append(patchName, dict, start);
        }
    }
    return patches;
}


void Foam::fsi::boxMesh::makeMesh()
{
    DynamicList<face> faces;
    DynamicList<label> owner;
    DynamicList<label> neighbour;
    addInternalFaces(faces, owner, neighbour);
    const dictionary patches(addBoundary(faces, owner));

    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion,
                nameOf(time_()),
                time_(),
                IOobject::READ_IF_PRESENT
            ),
            nodes(),
            faceList(faces),
            labelList(owner),
            labelList(neighbour)
        )
    );

    List<polyPatch*> boundary(patches.size());
    label patchi = 0;
    for (const entry& patch : patches)
    {
        boundary[patchi] = polyPatch::New
        (
            patch.keyword(),
            patch.dict(),
            patchi,
            mesh_().boundaryMesh()
        ).ptr();
        ++patchi;
    }
    mesh_().addFvPatches(boundary);
}


// ************************************************************************* //
