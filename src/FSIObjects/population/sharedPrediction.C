// SPDX-License-Identifier: GPL-3.0-or-later

#include "sharedPrediction.H"
#include "admmSolver.H"
#include "openfoamVersion.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using Foam::fsi::admmSolver;
using Foam::fsi::bodyGroup;

//- First copy of each group and rank, and the end: [group][rank]. None for
//  groups that are not divisible
labelListList rankStarts(const PtrList<bodyGroup>& groups)
{
    const label nRanks = fsi::nRanksIn();
    scalar all = 0;
    for (const bodyGroup& group : groups)
    {
        all += group.divisible() ? group.size()*group.shape().nNodes() : 0;
    }

    // A block belongs to the rank in whose part of all nodes its middle lies
    labelListList starts(groups.size());
    scalar before = 0;
    forAll(groups, groupi)
    {
        const bodyGroup& group = groups[groupi];
        if (!group.divisible())
        {
            continue;
        }
        starts[groupi].setSize(nRanks + 1, group.size());
        label ranki = 0;
        for (label first = 0; first < group.size();)
        {
            const label n = min(admmSolver::blockSize, group.size() - first);
            const scalar nodes = n*group.shape().nNodes();
            const label owner =
                min(label(nRanks*(before + 0.5*nodes)/all), nRanks - 1);
            while (ranki <= owner)
            {
                starts[groupi][ranki++] = first;
            }
            before += nodes;
            first += n;
        }
    }
    return starts;
}


//- Call action(group, range of copies) for what a rank solves
template<class Action>
void forShares
(
    const labelListList& starts,
    const label ranki,
    const Action& action
)
{
    forAll(starts, groupi)
    {
        const labelList& of = starts[groupi];
        if (of.size() && of[ranki] < of[ranki + 1])
        {
            action(groupi, labelRange(of[ranki], of[ranki + 1] - of[ranki]));
        }
    }
}


//- Give every rank the shares of all ranks
void exchange
(
    const PtrList<bodyGroup>& groups,
    const labelListList& starts,
    List<Eigen::MatrixXd>& v
)
{
    const auto columns = [&](const label groupi, const labelRange& copies)
    {
        const label nDims = groups[groupi].shape().nDims();
        return v[groupi].middleCols
        (
            nDims*fsi::firstOf(copies), nDims*copies.size()
        );
    };

    DynamicList<scalar> mine;
    forShares
    (
        starts,
        fsi::rankIn(),
        [&](const label groupi, const labelRange& copies)
        {
            const auto part = columns(groupi, copies);
            mine.append
            (
                UList<scalar>(const_cast<scalar*>(part.data()), part.size())
            );
        }
    );
    const List<scalarList> values(fsi::gatherOverRanks(scalarList(mine)));
    forAll(values, ranki)
    {
        const scalar* next = values[ranki].cdata();
        forShares
        (
            starts,
            ranki,
            [&](const label groupi, const labelRange& copies)
            {
                auto part = columns(groupi, copies);
                std::copy(next, next + part.size(), part.data());
                next += part.size();
            }
        );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::predictShared
(
    const population& objects,
    const scalar time,
    const scalar dt,
    const List<Eigen::MatrixXd>& force,
    List<Eigen::MatrixXd>& v
)
{
    const PtrList<bodyGroup>& groups = objects.groups();
    const bool shares = severalRanks();
    v.resize(groups.size());
    forAll(groups, groupi)
    {
        const bodyGroup& group = groups[groupi];
        if (shares && group.divisible())
        {
            v[groupi].resize(force[groupi].rows(), force[groupi].cols());
        }
        else
        {
            group.predict(time, dt, force[groupi], v[groupi]);
        }
    }
    if (shares)
    {
        const labelListList starts(rankStarts(groups));
        forShares
        (
            starts,
            fsi::rankIn(),
            [&](const label groupi, const labelRange& copies)
            {
                groups[groupi].predictRange
                (
                    dt,
                    force[groupi],
                    copies,
                    v[groupi]
                );
            }
        );
        exchange(groups, starts, v);
    }
}


// ************************************************************************* //
