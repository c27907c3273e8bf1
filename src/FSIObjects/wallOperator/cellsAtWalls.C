// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellsAtWalls.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cellsAtWalls::update(const interfaceGeometry& geometry)
{
    place_.setSize(geometry.grid().mesh().nCells(), -1);
    for (const label celli : cells_)
    {
        place_[celli] = -1;
    }
    for (const wallFace& w : geometry.wallFaces())
    {
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0)
            {
                place_[celli] = 0;
            }
        }
    }
    const boolList& active = geometry.activeCell();
    for (const filmFace& film : geometry.films().faces())
    {
        for (const label celli : geometry.grid().cellsBeside(film.face))
        {
            if (celli >= 0 && active[celli])
            {
                place_[celli] = 0;
            }
        }
    }
    cells_.clear();
    forAll(place_, celli)
    {
        if (place_[celli] >= 0)
        {
            place_[celli] = cells_.size();
            cells_.append(celli);
        }
    }
}


// ************************************************************************* //
