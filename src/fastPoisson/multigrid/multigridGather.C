// SPDX-License-Identifier: GPL-3.0-or-later

#include "multigridHierarchy.H"
#include "latticeRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::multigridHierarchy::addGather()
{
    gatherLevel_ = levels_.size() - 1;
    const multigridLevel& level = levels_[gatherLevel_];
    sendBuffer_.setSize(level.layout().nCells());

    gatherSize_.setSize(nRanks_);
    gatherOffset_.setSize(nRanks_);
    const blockPartition& partition = level.partition();
    const blockLayout whole = partition.whole().layout(0);
    DynamicList<label> places(partition.nCells());
    for (label ranki = 0; ranki < nRanks_; ++ranki)
    {
        const blockLayout box = partition.layout(ranki);
        gatherSize_[ranki] = box.nCells()*sizeof(float);
        gatherOffset_[ranki] = places.size()*sizeof(float);

        const labelVector& n = box.n();
        for (label cell = 0; cell < box.nCells(); ++cell)
        {
            const labelVector here
            (
                cell % n.x(), (cell/n.x()) % n.y(), cell/(n.x()*n.y())
            );
            places.append(whole.globalIndex(here + box.start()));
        }
    }
    if (rank_ == 0)
    {
        gatherPlace_.transfer(places);
        gatherBuffer_.setSize(gatherPlace_.size());
    }
}


void Foam::fsi::multigridHierarchy::gather
(
    const List<float>& part,
    List<float>& whole
)
{
    if (part.empty())
    {
        // The third direction of a lattice without it
        return;
    }

    label next = 0;
    forBox
    (
        levels_[gatherLevel_].layout(),
        [&](const label place) { sendBuffer_[next++] = part[place]; }
    );
    gatherToFirst
    (
        sendBuffer_, gatherBuffer_, gatherSize_, gatherOffset_, comm_
    );
    forAll(gatherPlace_, i)
    {
        whole[gatherPlace_[i]] = gatherBuffer_[i];
    }
}


void Foam::fsi::multigridHierarchy::scatter
(
    const List<float>& whole,
    List<float>& part
)
{
    forAll(gatherPlace_, i)
    {
        gatherBuffer_[i] = whole[gatherPlace_[i]];
    }
    scatterFromFirst
    (
        gatherBuffer_, sendBuffer_, gatherSize_, gatherOffset_, comm_
    );
    label next = 0;
    forBox
    (
        levels_[gatherLevel_].layout(),
        [&](const label place) { part[place] = sendBuffer_[next++]; }
    );
}


// ************************************************************************* //
