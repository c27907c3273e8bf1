// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMap.H"
#include "latticeRanks.H"
#include "Time.H"

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

namespace
{

// A cell may be this part of its size away from its place, and differ by it
// in volume: ASCII points have six digits
constexpr Foam::scalar latticeTolerance = 0.02;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cartesianMap::refuse(const string& reason) const
{
    FatalErrorInFunction
        << "The mesh " << mesh_.name() << " of " << mesh_.time().path()
        << " is not a uniform Cartesian lattice: " << reason << nl
        << "    cartesianMG and cartesianFFT need equal boxes along the axes."
        << nl << "    For this mesh use a general solver in fvSolution,"
        << " for example 'solver GAMG; smoother GaussSeidel;'."
        << exit(FatalError);
}


Foam::boundBox Foam::fsi::cartesianMap::firstCell() const
{
    boundBox box(boundBox::invertedBox);
    forAll(mesh_.faces(), facei)
    {
        if
        (
            mesh_.faceOwner()[facei] == 0
         || (
                facei < mesh_.nInternalFaces()
             && mesh_.faceNeighbour()[facei] == 0
            )
        )
        {
            for (const label pointi : mesh_.faces()[facei])
            {
                box.min() = min(box.min(), mesh_.points()[pointi]);
                box.max() = max(box.max(), mesh_.points()[pointi]);
            }
        }
    }
    return box;
}


void Foam::fsi::cartesianMap::findLattice()
{
    const boundBox& bounds = mesh_.bounds();

    vector size(vector::uniform(GREAT));
    if (mesh_.nCells())
    {
        size = firstCell().span();
    }
    reduceOverRanks(size, minOp<vector>(), mesh_.comm());

    labelVector meshN;
    for (direction d = 0; d < 3; ++d)
    {
        if (size[d] <= SMALL*bounds.mag())
        {
            refuse("a cell has no thickness");
        }
        meshN[d] = label(std::lround(bounds.span()[d]/size[d]));
    }

    direction next = 0;
    for (const bool thick : {true, false})
    {
        for (direction d = 0; d < 3; ++d)
        {
            if ((meshN[d] > 1) == thick)
            {
                axis_[next] = d;
                n_[next] = meshN[d];
                spacing_[next] = bounds.span()[d]/meshN[d];
                ++next;
            }
        }
    }

    const scalar places = scalar(n_.x())*scalar(n_.y())*scalar(n_.z());
    if (places > scalar(labelMax)/8)
    {
        refuse("the lattice would have " + Foam::name(places) + " places");
    }
}


void Foam::fsi::cartesianMap::findCells()
{
    const vectorField& centres = mesh_.cellCentres();
    const scalarField& volumes = mesh_.cellVolumes();
    const point& origin = mesh_.bounds().min();
    const scalar volume = spacing_.x()*spacing_.y()*spacing_.z();

    cells_.setSize(mesh_.nCells());
    forAll(cells_, celli)
    {
        if (mag(volumes[celli]/volume - 1) > latticeTolerance)
        {
            refuse("its cells have different volumes");
        }
        for (direction d = 0; d < 3; ++d)
        {
            const scalar place =
                (centres[celli][axis_[d]] - origin[axis_[d]])/spacing_[d]
              - 0.5;
            cells_[celli][d] = label(std::lround(place));
            if
            (
                mag(place - cells_[celli][d]) > latticeTolerance
             || cells_[celli][d] < 0 || cells_[celli][d] >= n_[d]
            )
            {
                refuse("cell centres are not evenly spaced");
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianMap::cartesianMap(const polyMesh& mesh)
:
    mesh_(mesh),
    axis_(direction(0)),
    n_(1, 1, 1),
    spacing_(Zero),
    patchCell_(mesh.boundaryMesh().size()),
    patchDirection_(mesh.boundaryMesh().size()),
    cyclic_(false)
{
    findLattice();
    findCells();
    findInternalFaces();

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            findPatchFaces(patch);
        }
    }
    for (bool& isCyclic : cyclic_)
    {
        reduceOverRanks(isCyclic, orOp<bool>(), mesh_.comm());
    }
}


// ************************************************************************* //
