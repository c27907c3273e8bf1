// SPDX-License-Identifier: GPL-3.0-or-later

#include "facesAcross.H"
#include "EdgeMap.H"
#include "labelPair.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::setFacesAcross
(
    const UList<surfaceFace>& faces,
    const label first,
    const label number,
    List<FixedList<label, 3>>& across
)
{
    // Face and its node opposite of the edges that were met once
    EdgeMap<labelPair> open;
    for (label facei = first; facei < first + number; ++facei)
    {
        across[facei] = FixedList<label, 3>(label(-1));
        const surfaceFace& f = faces[facei];
        for (label i = 0; i < 3; ++i)
        {
            const edge side(f[(i + 1) % 3], f[(i + 2) % 3]);
            const auto other = open.find(side);
            if (other == open.end())
            {
                open.insert(side, labelPair(facei, i));
                continue;
            }
            across[facei][i] = (*other).first();
            across[(*other).first()][(*other).second()] = facei;
            open.erase(other);
        }
    }
}


// ************************************************************************* //
