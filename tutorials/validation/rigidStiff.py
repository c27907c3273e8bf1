# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid bodies against the same as stiff elastic ones, whose strains are below
a thousandth: they turn in a shear and settle in the same way."""

import discs
import settlingSphere
import shearBox
from common import Row, at


def rows_of(what, grid, names, stiff, rigid):
    """A row for each figure of (figures, minutes)."""
    for name, a, b in zip(names, stiff[0], rigid[0]):
        yield Row(f"{what}, rigid, {name} over the stiff one's", grid, 1, b/a,
                  0.01, stiff[1] + rigid[1])


def turning(kind, cells, n_dims):
    """Angular velocity in a shear."""
    rate, minutes = shearBox.turning(kind, cells, n_dims)
    return [rate], minutes


def settling_disc(kind):
    """Largest speed and time at y = 2 cm of a disc that settles beside the
    middle of a tank, and its last angular velocity."""
    case = discs.tank(f"settling-{kind}", 8, 1.25, 0.1, [(0.7, 4)],
                      {"rigid": "type rigid;", "stiff": "E 1e5;"}[kind],
                      properties="output { objectsEvery 10; }",
                      deltaT=1e-3, endTime=0.5, writeInterval=0.5)
    minutes = case.solve()
    rows = case.objects()
    return [max(-row["velocityY"] for row in rows),
            at(rows, "centroidY", 2, "time")], minutes


def settling_sphere(kind):
    """Largest speed and time at a gap of two diameters."""
    rows, minutes = settlingSphere.oil("E4", 8, kind)
    return [max(-row["velocityY"] for row in rows),
            at(rows, "centroidY", 2.5*settlingSphere.DIAMETER, "time")], minutes


def compare():
    """All four."""
    fall = ("largest speed", "time to a height")
    for what, grid, names, function, values in (
            ("disc in shear", "a/h = 8", ["angular velocity"], turning, (8, 2)),
            ("settling disc", "d/h = 8", fall, settling_disc, ()),
            ("sphere in shear", "a/h = 4", ["angular velocity"], turning,
             (4, 3)),
            ("settling sphere", "D/h = 6", fall, settling_sphere, ())):
        yield from rows_of(what, grid, names, function("stiff", *values),
                           function("rigid", *values))


CASES = {"rigidStiff": compare}
