// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMap.H"
#include "cyclicPolyPatch.H"
#include "openfoamMesh.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::pair<Foam::direction, Foam::label> Foam::fsi::cartesianMap::side
(
    const vector& area
) const
{
    direction largest = 0;
    for (direction d = 1; d < 3; ++d)
    {
        if (mag(area[axis_[d]]) > mag(area[axis_[largest]]))
        {
            largest = d;
        }
    }
    return {largest, area[axis_[largest]] > 0 ? 1 : -1};
}


void Foam::fsi::cartesianMap::findInternalFaces()
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();

    faceCell_.setSize(mesh_.nInternalFaces());
    faceDirection_.setSize(mesh_.nInternalFaces());
    forAll(faceCell_, facei)
    {
        const labelVector step =
            cells_[neighbour[facei]] - cells_[owner[facei]];

        if (mag(step.x()) + mag(step.y()) + mag(step.z()) != 1)
        {
            refuse("a face joins cells that are not neighbours");
        }
        const direction d = step.x() ? 0 : step.y() ? 1 : 2;
        faceDirection_[facei] = d;
        faceCell_[facei] = step[d] > 0 ? neighbour[facei] : owner[facei];
    }
}


void Foam::fsi::cartesianMap::checkCyclic(const polyPatch& patch) const
{
    const cyclicPolyPatch& cyclic = refCast<const cyclicPolyPatch>(patch);
    const labelUList& faceCells = patch.faceCells();
    const labelUList& opposite = oppositeOf(cyclic).faceCells();

    forAll(faceCells, i)
    {
        labelVector expected = cells_[faceCells[i]];
        const auto face = side(patch.faceAreas()[i]);
        const direction d = face.first;
        expected[d] = (expected[d] + face.second + n_[d]) % n_[d];
        if (expected != cells_[opposite[i]])
        {
            refuse("cyclic patch " + patch.name() + " shifts its cells");
        }
    }
}


void Foam::fsi::cartesianMap::findPatchFaces(const polyPatch& patch)
{
    const bool isCyclic = isA<cyclicPolyPatch>(patch);
    const bool wraps = isCyclic || isA<processorCyclicPolyPatch>(patch);

    if (!isCyclic && !isA<processorPolyPatch>(patch))
    {
        refuse("patch " + patch.name() + " is of type " + patch.type());
    }
    if (rotates(refCast<const coupledPolyPatch>(patch)))
    {
        refuse("patch " + patch.name() + " rotates");
    }

    labelList& cell = patchCell_[patch.index()];
    List<direction>& dir = patchDirection_[patch.index()];
    cell.setSize(patch.size());
    dir.setSize(patch.size());
    forAll(patch, i)
    {
        const label own = patch.faceCells()[i];
        const auto face = side(patch.faceAreas()[i]);
        const direction d = face.first;
        const label next = cells_[own][d] + face.second;
        const bool leaves = next < 0 || next >= n_[d];
        if (leaves != wraps)
        {
            refuse("patch " + patch.name() + " joins cells inside");
        }
        cyclic_[d] = cyclic_[d] || wraps;
        dir[i] = d;
        cell[i] = face.second < 0 ? own : -1;
    }
    if (isCyclic)
    {
        checkCyclic(patch);
    }
}


// ************************************************************************* //
