// SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeMesh.H"
#include "openfoamCase.H"
#include "openfoamVersion.H"
#include <algorithm>
#include <random>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::latticeMesh::place(const labelVector& ijk) const
{
    const labelVector& n = options_.n;
    return ijk.x() + n.x()*(ijk.y() + n.y()*ijk.z());
}


bool Foam::fsi::latticeMesh::hole(const labelVector& ijk) const
{
    return options_.hole && options_.hole(ijk);
}


Foam::label Foam::fsi::latticeMesh::rankOf(const labelVector& ijk) const
{
    if (options_.rank)
    {
        return options_.rank(ijk);
    }
    return ijk.x()*Pstream::nProcs()/options_.n.x();
}


void Foam::fsi::latticeMesh::numberCells()
{
    const labelVector& n = options_.n;
    DynamicList<labelVector> mine;
    for (label k = 0; k < n.z(); ++k)
    {
        for (label j = 0; j < n.y(); ++j)
        {
            for (label i = 0; i < n.x(); ++i)
            {
                const labelVector ijk(i, j, k);
                if (!hole(ijk) && rankOf(ijk) == Pstream::myProcNo())
                {
                    mine.append(ijk);
                }
            }
        }
    }
    cells_.transfer(mine);
    if (options_.shuffled)
    {
        std::mt19937 generator(7);
        std::shuffle(cells_.begin(), cells_.end(), generator);
    }
    cellAt_.setSize(n.x()*n.y()*n.z(), -1);
    forAll(cells_, celli)
    {
        cellAt_[place(cells_[celli])] = celli;
    }
}


void Foam::fsi::latticeMesh::makeTime()
{
    dictionary controls;
    controls.add("startTime", scalar(0));
    controls.add("endTime", scalar(1));
    controls.add("deltaT", scalar(1));
    controls.add("writeControl", word("timeStep"));
    controls.add("writeInterval", labelMax);
    controls.add("runTimeModifiable", word("no"));

    word caseName("fastPoissonTests");
    time_ = newTime
    (
        controls, fileName("/tmp"),
        Pstream::parRun()
      ? fileName(caseName/("processor" + name(Pstream::myProcNo())))
      : fileName(caseName)
    );
}


void Foam::fsi::latticeMesh::addPatchFaces
(
    DynamicList<face>& faces,
    DynamicList<label>& owner
)
{
    for (auto& patch : patches_)
    {
        patch.second.dict.add("startFace", faces.size());
        patch.second.dict.add("nFaces", label(patch.second.faces.size()));
        for (const auto& found : patch.second.faces)
        {
            faces.append(found.second.first);
            owner.append(found.second.second);
        }
    }
}


void Foam::fsi::latticeMesh::makeMesh()
{
    DynamicList<face> faces;
    DynamicList<label> owner;
    DynamicList<label> neighbour;

    // Internal faces in upper-triangular order
    makeOuterPatches();
    forAll(cells_, celli)
    {
        std::map<label, face> higher;
        for (direction d = 0; d < 3; ++d)
        {
            for (label side = 0; side < 2; ++side)
            {
                labelVector next(cells_[celli]);
                next[d] += 2*side - 1;
                const bool inside = next[d] >= 0 && next[d] < options_.n[d];
                const label other = inside ? cellAt_[place(next)] : -1;
                if (other > celli)
                {
                    higher[other] = cellFace(cells_[celli], d, side);
                }
                else if (other < 0)
                {
                    addBoundaryFace(cells_[celli], d, side);
                }
            }
        }
        for (const auto& found : higher)
        {
            faces.append(found.second);
            owner.append(celli);
            neighbour.append(found.first);
        }
    }

    addPatchFaces(faces, owner);

    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion, nameOf(time_()), time_(),
                IOobject::NO_READ
            ),
            pointField(points_), faceList(faces), labelList(owner),
            labelList(neighbour)
        )
    );
    List<polyPatch*> boundary(patches_.size());
    forAll(boundary, patchi)
    {
        boundary[patchi] = polyPatch::New
        (
            patches_[patchi].first, patches_[patchi].second.dict, patchi,
            mesh_().boundaryMesh()
        ).ptr();
    }
    mesh_().addFvPatches(boundary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::latticeMesh::latticeMesh(const latticeOptions& options)
:
    options_(options),
    nodes_
    (
        (options.n.x() + 1)*(options.n.y() + 1)*(options.n.z() + 1), -1
    )
{
    numberCells();
    makeTime();
    makeMesh();
}


// ************************************************************************* //
