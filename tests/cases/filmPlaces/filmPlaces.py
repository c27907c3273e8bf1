#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two discs approach each other along an axis of the mesh, with a film thinner
than a cell, at several places in the mesh; a disc slides along a wall; a free
disc is pushed to a wall with a large step.

    filmPlaces.py FOLDER

The pressure of a film changes within a cell. With the profile of the film
(theory.md, (5.33)) the force is the exact one to some per cent at each place;
where cells have one pressure, it is 1.2 to 1.9 times as large at 0.1 h. A disc
that slides on a wall is not pushed from it; without the profile it has half
of the force of sliding. Of two discs that roll on each other both have the
force; where the cells' centres say which one gets the friction (5.36), one has
up to 1.5 of it. At the last place the film goes by a corner of cells, and the
discs have 0.7 of the force if a face that both close is open. The tolerances
are those of the validation.
"""

import os
import sys

import fsiCase

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../../../tutorials/validation"))

import lubrication  # noqa: E402
import resistances  # noqa: E402
import wallFilms  # noqa: E402

RADIUS, STEP = 4, 10


#: The film goes by a corner of cells
CORNER = ([0.651592972722763, 0.7887233511355132],
          [0.8310868751185205, 0.5561426130101277, 0],
          [-0.5561426130101277, 0.8310868751185205, 0], [0, 0, 1])


def along_axis(place):
    """The discs' middle at a place in the mesh, and the directions."""
    return [place, 0.3 + place], [1, 0, 0], [0, 1, 0], [0, 0, 1]


def ratios(motion, gap, place, across=False):
    """Forces of both discs over the exact one, or those across to it."""
    found, _ = resistances.forces(motion, gap, STEP, RADIUS, place)
    known = resistances.exact()[round(gap/RADIUS, 6)][motion + "Force"]
    along = 0 if (motion == "squeeze") != across else 1
    return [abs(body[along])/known for body in found]


def main(folder):
    """All checks."""
    os.chdir(folder)
    report = fsiCase.Report()
    for gap in (0.2, 0.1):
        for place in (0, 0.25, 0.5, 0.75):
            found = ratios("squeeze", gap, along_axis(place))[1]
            report.check(f"gap of {gap} h, place {place}",
                         abs(found - 1) < 0.1, found)
    found = ratios("squeeze", 0.1, CORNER)[1]
    report.check("film by a corner of cells", abs(found - 1) < 0.2, found)
    for place in (0.1, 0.35, 0.6, 0.85):
        found = ratios("roll", 0.2, along_axis(place))
        report.check(f"both discs that roll, place {place}",
                     max(abs(x - 1) for x in found) < 0.25, found)
    # A surface goes by the corner of a face that it closes
    found = ratios("roll", 0.2, ([0.828, 0.25], *along_axis(0)[1:]), True)
    report.check("discs that roll are not pushed across", max(found) < 0.5,
                 found)
    for row in wallFilms.rows(2, "slide", 0.1, STEP, RADIUS, [[0.1], [0.6]]):
        if "force on the wall" in row.what:
            report.check(row.what, abs(row.value) < 0.1, row.value)
    row = lubrication.approach(2, 1, 40)
    report.check(row.what + ", " + row.grid, abs(row.value - 1) < 0.1,
                 row.value)


if __name__ == "__main__":
    main(sys.argv[1])
