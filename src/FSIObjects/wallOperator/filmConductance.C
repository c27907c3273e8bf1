// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmConductance.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmConductance::addCell(const label at)
{
    if (row_[at] < 0)
    {
        row_[at] = carriers_.size();
        carriers_.append(DynamicList<carrier>());
    }
}


void Foam::fsi::filmConductance::addCarrier
(
    const label at,
    const label node,
    const vector& area
)
{
    if (at < 0 || row_[at] < 0)
    {
        return;
    }
    DynamicList<carrier>& ofCell = carriers_[row_[at]];
    for (carrier& c : ofCell)
    {
        if (c.node == node)
        {
            c.area += area;
            return;
        }
    }
    ofCell.append({node, area});
}


Foam::scalar Foam::fsi::filmConductance::between
(
    const label lower,
    const label upper,
    const vectorField& mobility
) const
{
    scalar sum = 0;
    for (const carrier& a : carriers_[row_[lower]])
    {
        for (const carrier& b : carriers_[row_[upper]])
        {
            if (a.node == b.node)
            {
                const vector products(cmptMultiply(a.area, b.area));
                sum += min(products, vector::zero) & mobility[a.node];
            }
        }
    }
    return -factor*sum;
}


// ************************************************************************* //
