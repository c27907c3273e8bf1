// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockPartition.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelVector Foam::fsi::blockPartition::leastSurface
(
    const labelVector& n,
    const label nBoxes
)
{
    scalar least = GREAT;
    labelVector best(0, 0, 0);
    for (label px = 1; px <= min(nBoxes, n.x()); ++px)
    {
        for (label py = 1; py <= min(nBoxes/px, n.y()); ++py)
        {
            const label pz = nBoxes/(px*py);
            const scalar surface =
                scalar(px)/n.x() + scalar(py)/n.y() + scalar(pz)/n.z();
            if (px*py*pz == nBoxes && pz <= n.z() && surface < least)
            {
                least = surface;
                best = labelVector(px, py, pz);
            }
        }
    }
    return best;
}


void Foam::fsi::blockPartition::makeBoxes
(
    const cartesianMap& map,
    const label nRanks
)
{
    // Where the lattice cannot be cut into so many boxes (13 for 8 x 8 cells),
    // the last ranks have none
    const labelVector& n = map.n();
    label nMade = nRanks;
    labelVector best(leastSurface(n, nMade));
    while (!best.x())
    {
        best = leastSurface(n, --nMade);
    }

    for (direction d = 0; d < 3; ++d)
    {
        cuts_[d].setSize(best[d] + 1);
        forAll(cuts_[d], i)
        {
            // Even places, so that pairs of cells stay together, if possible
            const label place = label(int64_t(n[d])*i/best[d]);
            const bool even = n[d] >= 4*best[d] && i < best[d];
            cuts_[d][i] = even ? 2*((place + 1)/2) : place;
        }
    }
    rank_ = identityList(nMade);
}


// ************************************************************************* //
