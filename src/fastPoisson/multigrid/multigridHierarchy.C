// SPDX-License-Identifier: GPL-3.0-or-later

#include "multigridHierarchy.H"
#include "latticeRanks.H"

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

namespace
{

// Cells of a level that is solved directly
constexpr Foam::label coarsestCells = 36;

// Directions whose coupling is at least this part of the strongest coarsen
constexpr Foam::scalar strongCoupling = 0.4;

} // End anonymous namespace


Foam::fsi::levelShift Foam::fsi::multigridHierarchy::chooseShift
(
    const blockPartition& partition,
    vector& weights
)
{
    scalar strongest = 0;
    for (direction d = 0; d < 3; ++d)
    {
        if (partition.n(d) > 1)
        {
            strongest = max(strongest, weights[d]);
        }
    }
    int shift[3];
    for (direction d = 0; d < 3; ++d)
    {
        const bool strong = weights[d] >= strongCoupling*strongest;
        shift[d] = partition.n(d) > 1 && strong;
        weights[d] *= shift[d] ? 0.25 : 1;
    }
    return levelShift{shift[0], shift[1], shift[2]};
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::multigridHierarchy::multigridHierarchy
(
    const blockPartition& partition,
    const vector& weights,
    const controls& choices,
    const label comm
)
:
    controls_(choices),
    comm_(comm),
    rank_(rankIn(comm)),
    nRanks_(nRanksIn(comm)),
    gatherLevel_(-1)
{
    const label gatherCells = max(controls_.gatherCells, coarsestCells);
    vector couplings(weights);
    blockPartition next(partition);
    DynamicList<levelShift> shifts;
    bool gathered = nRanks_ == 1;

    while (true)
    {
        levels_.append(new multigridLevel(next, rank_, comm_));
        if (!gathered && next.nCells() <= gatherCells)
        {
            addGather();
            next = next.whole();
            shifts.append(levelShift{0, 0, 0});
            gathered = true;
            if (rank_ != 0)
            {
                break;
            }
        }
        else if (next.nCells() <= coarsestCells)
        {
            break;
        }
        else
        {
            shifts.append(chooseShift(next, couplings));
            const levelShift& shift = shifts.last();
            next = next.coarsened(labelVector(shift.x, shift.y, shift.z));
        }
    }
    shift_.transfer(shifts);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::multigridHierarchy::updateCoarsest()
{
    const multigridLevel& level = levels_.last();
    const labelVector& n = level.layout().n();
    const label nCells = level.layout().nCells();
    scalarField matrix(nCells*nCells, Zero);

    for (label cell = 0; cell < nCells; ++cell)
    {
        const labelVector here
        (
            cell % n.x(), (cell/n.x()) % n.y(), cell/(n.x()*n.y())
        );
        const label place = level.layout().globalIndex(here);
        matrix[(nCells + 1)*cell] += level.excess()[place];

        for (direction d = 0; d < 3; ++d)
        {
            if (n[d] > 1)
            {
                labelVector before(here);
                before[d] = (here[d] + n[d] - 1) % n[d];
                const label other =
                    before.x() + n.x()*(before.y() + n.y()*before.z());
                const scalar a = level.face(d)[place];
                matrix[(nCells + 1)*cell] += a;
                matrix[(nCells + 1)*other] += a;
                matrix[nCells*cell + other] -= a;
                matrix[nCells*other + cell] -= a;
            }
        }
    }
    coarsest_.set(nCells, matrix);
}


void Foam::fsi::multigridHierarchy::solveCoarsest()
{
    multigridLevel& level = levels_.last();
    label next = 0;
    forBox
    (
        level.layout(),
        [&](const label place) { coarsest_.b()[next++] = level.b()[place]; }
    );
    const scalarField& x = coarsest_.solve();
    next = 0;
    forBox
    (
        level.layout(),
        [&](const label place) { level.x()[place] = float(x[next++]); }
    );
}


void Foam::fsi::multigridHierarchy::solve(const label leveli)
{
    if (leveli == gatherLevel_)
    {
        const bool first = rank_ == 0;
        gather(levels_[leveli].b(), levels_[leveli + first].b());
        if (first)
        {
            solve(leveli + 1);
        }
        scatter(levels_[leveli + first].x(), levels_[leveli].x());
    }
    else if (leveli == levels_.size() - 1)
    {
        solveCoarsest();
    }
    else
    {
        cycle(leveli, true);
        const label nCells = levels_[leveli].partition().nCells();
        if (leveli > 0 && nCells <= controls_.wCycleCells)
        {
            cycle(leveli, false);
        }
    }
}


void Foam::fsi::multigridHierarchy::cycle
(
    const label leveli,
    const bool fromZero
)
{
    multigridLevel& level = levels_[leveli];
    multigridLevel& coarse = levels_[leveli + 1];
    const levelShift& shift = shift_[leveli];

    level.down(fromZero, shift, coarse);
    solve(leveli + 1);
    level.up(shift, coarse);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::multigridHierarchy::update()
{
    levels_[0].finish();
    for (label leveli = 0; leveli + 1 < levels_.size(); ++leveli)
    {
        if (leveli != gatherLevel_)
        {
            levels_[leveli].coarsen(shift_[leveli], levels_[leveli + 1]);
            continue;
        }
        for (direction d = 0; d < 3; ++d)
        {
            gather(levels_[leveli].face(d), levels_[leveli + 1].face(d));
        }
        gather(levels_[leveli].excess(), levels_[leveli + 1].excess());
        levels_[leveli + 1].finish();
    }
    if (gatherLevel_ >= 0 && rank_ != 0)
    {
        // The other ranks send only
        for (direction d = 0; d < 3; ++d)
        {
            gather(levels_.last().face(d), levels_.last().face(d));
        }
        gather(levels_.last().excess(), levels_.last().excess());
        return;
    }
    updateCoarsest();
}


void Foam::fsi::multigridHierarchy::cycle()
{
    solve(0);
}


void Foam::fsi::multigridHierarchy::cycleCoarse()
{
    if (levels_.size() == 1 || gatherLevel_ == 0)
    {
        solve(0);
        return;
    }
    levels_[0].restrictSource(shift_[0], levels_[1]);
    solve(1);
    levels_[0].interpolate(shift_[0], levels_[1]);
}


// ************************************************************************* //
