// SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const char* const sideNames[3][2] =
{
    {"xMin", "xMax"}, {"yMin", "yMax"}, {"zMin", "zMax"}
};

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::latticeMesh::node(const labelVector& ijk)
{
    const labelVector& n = options_.n;
    const label key =
        ijk.x() + (n.x() + 1)*(ijk.y() + (n.y() + 1)*ijk.z());
    if (nodes_[key] >= 0)
    {
        return nodes_[key];
    }
    point position
    (
        cmptMultiply(vector(ijk.x(), ijk.y(), ijk.z()), options_.spacing)
    );
    points_.append(options_.distort ? options_.distort(position) : position);
    nodes_[key] = points_.size() - 1;
    return points_.size() - 1;
}


Foam::face Foam::fsi::latticeMesh::cellFace
(
    const labelVector& ijk,
    const direction d,
    const label side
)
{
    labelVector first(ijk);
    first[d] += side;
    labelVector a(labelVector::zero);
    labelVector b(labelVector::zero);
    a[(d + 1) % 3] = 1;
    b[(d + 2) % 3] = 1;
    if (side == 0)
    {
        Swap(a, b);
    }
    face f(4);
    f[0] = node(first);
    f[1] = node(first + a);
    f[2] = node(first + a + b);
    f[3] = node(first + b);
    return f;
}


Foam::fsi::latticeMesh::patchFaces& Foam::fsi::latticeMesh::patch
(
    const word& name,
    const word& type
)
{
    for (auto& existing : patches_)
    {
        if (existing.first == name)
        {
            return existing.second;
        }
    }
    patches_.emplace_back(name, patchFaces());
    patches_.back().second.dict.add("type", type);
    return patches_.back().second;
}


void Foam::fsi::latticeMesh::makeOuterPatches()
{
    for (direction d = 0; d < 3; ++d)
    {
        for (label side = 0; side < 2 && d != options_.emptyDirection; ++side)
        {
            patchFaces& outer = patch
            (
                sideNames[d][side],
                options_.cyclic[d] ? "cyclic" : "wall"
            );
            if (options_.cyclic[d])
            {
                vector separation(Zero);
                separation[d] =
                    options_.spacing[d]*options_.n[d]*(side ? -1 : 1);
                outer.dict.add
                (
                    "neighbourPatch", word(sideNames[d][1 - side])
                );
                outer.dict.add("transform", word("translational"));
                outer.dict.add("separationVector", separation);
                // The Foundation's separation has the other sign
                outer.dict.add("transformType", word("translational"));
                outer.dict.add("separation", vector(-separation));
            }
        }
    }
    if (options_.emptyDirection < 3)
    {
        patch("frontAndBack", "empty");
    }
    patch("holes", "wall");

    // Two ranks must have the patches they share in the same order
    for (label other = 0; other < Pstream::nProcs(); ++other)
    {
        if (other != Pstream::myProcNo())
        {
            makeSharedPatches(other);
        }
    }
}


void Foam::fsi::latticeMesh::makeSharedPatches(const label other)
{
    const word name("procBoundaryTo" + Foam::name(other));
    const auto addRanks = [&](patchFaces& shared)
    {
        shared.dict.add("myProcNo", label(Pstream::myProcNo()));
        shared.dict.add("neighbProcNo", other);
    };
    addRanks(patch(name, "processor"));

    // The low side for one rank is the high side for the other
    const label first = other < Pstream::myProcNo() ? 1 : 0;
    for (direction d = 0; d < 3; ++d)
    {
        for (const label side : {first, 1 - first})
        {
            if (options_.cyclic[d])
            {
                const word refer(sideNames[d][side]);
                patchFaces& shared =
                    patch(name + "through" + refer, "processorCyclic");
                shared.dict.add("referPatch", refer);
                addRanks(shared);
            }
        }
    }
}


void Foam::fsi::latticeMesh::addSharedFace
(
    const labelVector& ijk,
    const direction d,
    const label side,
    const bool wraps,
    const label other
)
{
    // Both ranks have one key: the cell on the low side of the face
    labelVector low(ijk);
    low[d] = (low[d] - 1 + side + options_.n[d]) % options_.n[d];
    const label key = 3*place(low) + d;

    word name("procBoundaryTo" + Foam::name(other));
    if (wraps)
    {
        name += word("through") + sideNames[d][side];
    }
    patchFaces& shared = patch(name, wraps ? "processorCyclic" : "processor");
    shared.faces[key] = {cellFace(ijk, d, side), cellAt_[place(ijk)]};
}


void Foam::fsi::latticeMesh::addBoundaryFace
(
    const labelVector& ijk,
    const direction d,
    const label side
)
{
    const label celli = cellAt_[place(ijk)];
    const std::pair<face, label> here{cellFace(ijk, d, side), celli};
    if (label(d) == options_.emptyDirection)
    {
        patch("frontAndBack", "empty").faces[2*place(ijk) + side] = here;
        return;
    }

    labelVector next(ijk);
    next[d] += 2*side - 1;
    const bool leaves = next[d] < 0 || next[d] >= options_.n[d];
    const word sideName(sideNames[d][side]);
    if (leaves && !options_.cyclic[d])
    {
        patch(sideName, "wall").faces[place(ijk)] = here;
        return;
    }
    next[d] = (next[d] + options_.n[d]) % options_.n[d];
    if (hole(next))
    {
        patch("holes", "wall").faces[6*place(ijk) + 2*d + side] = here;
    }
    else if (rankOf(next) != Pstream::myProcNo())
    {
        addSharedFace(ijk, d, side, leaves, rankOf(next));
    }
    else
    {
        // Both halves of the cyclic in the order of the other directions
        labelVector flat(ijk);
        flat[d] = 0;
        patch(sideName, "cyclic").faces[place(flat)] = here;
    }
}


// ************************************************************************* //
