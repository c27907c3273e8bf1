# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft disc in a driven cavity (Zhao 2008, Sugiyama 2011).

The reference is a list of points of the path: the height of the left turn,
where the path is vertical, is the vertex of the parabola through the three
points about it, (0.3127 0.6439), (0.2894 0.7211), (0.2958 0.7939).
"""

from common import Case, Row, disc, placed


def soft_disc():
    """Turning points of the disc's centre."""
    for cells, tolerance in ((32, None), (64, 0.03), (128, 0.02)):
        # A triangular network of modulus E has the shear modulus 3 E/8 = 0.1
        case = Case(
            f"softDisc-{cells}", cells=(cells, cells), viscosity=0.01,
            walls={"top": "(1 0 0)"},
            properties="contact { range 1; } output { objectsEvery 2; }",
            shapes=disc(0.2, "density 1; E 0.26667;"),
            placements=placed("disc", (0.6, 0.5)),
            deltaT=0.32/cells, endTime=7, writeInterval=1)
        minutes = case.solve()
        rows = case.objects()

        left = min(rows, key=lambda row: row["centroidX"])
        rows = [row for row in rows if row["time"] > left["time"]]
        top = max(rows, key=lambda row: row["centroidY"])
        rows = [row for row in rows if row["time"] > top["time"]]
        right = max(rows, key=lambda row: row["centroidX"])
        for name, reference, value in (
                ("x at its first left turn", 0.2894, left["centroidX"]),
                ("y at its first left turn", 0.7406, left["centroidY"]),
                ("y at its first top", 0.8684, top["centroidY"]),
                ("x at its first right turn", 0.7021, right["centroidX"]),
                ("y at its first right turn", 0.7662, right["centroidY"])):
            yield Row("soft disc, " + name, f"h = 1/{cells}", reference, value,
                      tolerance, minutes, ("soft disc, " + name, cells))


CASES = {"softDisc": soft_disc}
