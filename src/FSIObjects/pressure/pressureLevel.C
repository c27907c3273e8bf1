// SPDX-License-Identifier: GPL-3.0-or-later

#include "pressureLevel.H"
#include "errorOf.H"
#include "readBetween.H"
#include "stateFile.H"
#include "stepControls.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

//- The file of the state
static const Foam::word stateName("fsiPressureLevel");


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::pressureLevel::findCell
(
    const dictionary& controls,
    const cartesianMesh& grid
)
{
    const fvMesh& mesh = p_.mesh();
    if (controls.found("pRefCell"))
    {
        cell_ = readEntry<label>(controls, "pRefCell");
        const label nCells = gatherOverRanks(mesh.nCells())[rank_];
        if (cell_ < 0 || cell_ >= nCells)
        {
            FatalIOErrorInFunction(controls)
                << "Entry 'pRefCell' in dictionary " << controls.name()
                << " is " << cell_ << " but must be in 0 to " << nCells - 1
                << exit(FatalIOError);
        }
        return;
    }
    const point place(readFinite(controls, "pRefPoint"));
    const boundBox& box = mesh.bounds();
    if (box.contains(place))
    {
        // Points on a side belong to the cell inside
        const point middle(0.5*(box.min() + box.max()));
        cell_ = grid.findCell(place + 1e-9*(middle - place));
    }
    const labelList cells(gatherOverRanks(cell_));
    while (rank_ < cells.size() && cells[rank_] < 0)
    {
        ++rank_;
    }
    if (rank_ == cells.size())
    {
        FatalIOErrorInFunction(controls)
            << "Entry 'pRefPoint' in dictionary " << controls.name() << " is "
            << place << " but must be in the mesh" << exit(FatalIOError);
    }
}


void Foam::fsi::pressureLevel::add(const scalar value)
{
    p_.primitiveFieldRef() += value;
    p_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::pressureLevel::pressureLevel
(
    volScalarField& p,
    const cartesianMesh& grid
)
:
    p_(p),
    given_(false),
    cell_(-1),
    rank_(0),
    value_(0),
    added_(0)
{
    if (!p.needReference())
    {
        return;
    }
    const dictionary controls(stepControls(p.mesh()));
    given_ = controls.found("pRefCell") || controls.found("pRefPoint");
    value_ = readEntryOr<scalar>(controls, "pRefValue", 0);
    checkValues(controls, "pRefValue", scalarList(1, value_));
    if (given_)
    {
        findCell(controls, grid);
    }
    else if (value_ != 0)
    {
        FatalIOErrorInFunction(controls)
            << "Entry 'pRefValue' in dictionary " << controls.name() << " is "
            << value_ << ": it needs an entry 'pRefCell' or 'pRefPoint'"
            << exit(FatalIOError);
    }
    const dictionary state(readState(p.time(), stateName));
    if (!state.empty())
    {
        added_ = readEntry<scalar>(state, "added");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::pressureLevel::remove()
{
    if (added_ != 0)
    {
        add(-added_);
        added_ = 0;
    }
}


void Foam::fsi::pressureLevel::set()
{
    if (!given_)
    {
        return;
    }
    const bool here = cell_ >= 0 && cell_ < p_.size();
    added_ = value_ - gatherOverRanks(here ? p_[cell_] : 0)[rank_];
    add(added_);

    const Time& time = p_.time();
    if (time.writeTime())
    {
        writeFile
        (
            time, nameOf(time), "uniform", stateName, IOstream::ASCII,
            [&](Ostream& os) { putEntry(os, "added", added_); }
        );
    }
}


// ************************************************************************* //
