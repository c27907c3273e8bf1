#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that collide keep their areas, with the couplings none and weak as
well.

    couplings.py FOLDER
"""

import os
import sys

import fsiCase
import results

SHAPES = """
disc
{{
    shape {{ type circle; radius 0.15; }}
    material {{ density {0}; E {1}; }}
}}
"""
PLACEMENTS = """
a
{
    type listed;
    shape disc;
    objects ({ centre (0.3 0.5 0); velocity (2 0 0); });
}
b
{
    type listed;
    shape disc;
    objects ({ centre (0.7 0.52 0); velocity (-2 0 0); });
}
"""

# Coupling, density and modulus: weak is stable with heavy and stiff discs only
RUNS = (("none", 5, 100), ("weak", 100, 1e5))

# Rounding; one correction per step leaves the square of a step's change
TOLERANCE = 1e-9


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for name, density, modulus in RUNS:
        case = fsiCase.Case(
            os.path.join(folder, name), shapes=SHAPES.format(density, modulus),
            placements=PLACEMENTS,
            properties=fsiCase.THESIS + f"coupling {{ type {name}; }}\n"
                       "output { objectsEvery 1; }\n",
            deltaT=0.002, endTime=0.1, writeInterval=50).set_up()
        case.run("fsiPisoFoam")
        rows = results.table(case.path, "global.csv")
        report.check(f"{name}: they touch",
                     max(r["contacts"] for r in rows) > 0, "no contact")
        change = max(abs(r["areaChange"]) for r in rows)
        report.check(f"{name}: no area is lost", change < TOLERANCE,
                     f"{change}")


if __name__ == "__main__":
    main(sys.argv[1])
