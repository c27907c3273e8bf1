# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc that settles in a channel, seen from the channel and from a frame that
moves along with it (movingFrame): two runs of the same motion.

The channel is four diameters wide. In the frame at rest it is 24 diameters
long and closed; in the moving one it has 12, with a given velocity below and an
open end above. The terminal velocity is the mean over the last three seconds,
in which the disc passes many cells of the frame at rest.
"""

import results
from common import Case, Row, at, disc, placed

DIAMETER = 0.25

OPEN = {"bottom": ("type fixedValue; value uniform (0 0 0);",
                   "type zeroGradient;"),
        "top": ("type zeroGradient;", "type fixedValue; value uniform 0;")}


def settle(cells, moves):
    """A disc of so many cells settles for 20 s; rows with time, place and
    velocity in the frame at rest, and the minutes."""
    height = 3 if moves else 6
    start = 1.5 if moves else 5
    case = Case(
        f"frame-{'moves' if moves else 'rests'}-{cells}",
        box=(0, 0, 1, height), cells=(4*cells, 4*height*cells), viscosity=0.01,
        gravity="(0 -1 0)", open=OPEN if moves else {},
        shapes=disc(DIAMETER/2, "type rigid; density 1.5;"),
        placements=placed("disc", (0.5, start)),
        properties="output { objectsEvery 1; }" + (
            "frame { follow 0; direction (0 1 0); }" if moves else ""),
        deltaT=1.28*DIAMETER/cells, endTime=20, writeInterval=20)
    minutes = case.solve()
    rows = [[row["time"], row["centroidY"] - start, row["velocityY"]]
            for row in case.objects()]
    if moves:
        frame = {row["time"]: row
                 for row in results.table(case.path, "frame.csv")}
        for row in rows:
            row[1] += frame[row[0]]["positionY"]
            row[2] += frame[row[0]]["velocityY"]
    return [dict(zip(("time", "y", "speed"), row)) for row in rows], minutes


def compare():
    """Terminal velocity and way."""
    for cells in (8, 16):
        rows, minutes = {}, 0
        for moves in (False, True):
            rows[moves], spent = settle(cells, moves)
            minutes += spent
        ways = [r[-1]["y"] for r in rows.values()]
        speeds = [(r[-1]["y"] - at(r, "time", 17, "y"))/3
                  for r in rows.values()]
        late = [at(r, "time", 2, "speed") for r in rows.values()]
        for what, (reference, value) in (
                ("terminal velocity", speeds), ("velocity at 2 s", late),
                ("way in 20 s", ways)):
            yield Row(f"disc settles, moving frame against one at rest, {what}",
                      f"d/h = {cells}", reference, value,
                      0.005*abs(reference), minutes)


CASES = {"frame": compare}
