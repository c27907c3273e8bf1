#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two discs side by side are driven into a channel that narrows to less than
the width of either. Soft ones squeeze through, one after the other; stiff ones
jam. Neither ever overlap or leave the channel, and contact fires none off, not
even one that yields: a hundredth of a Pascal against the 30 that press leaves
films thinner than a tenth of a cell. Nor is the fluid in these films faster
than what drives it there.

    squeeze.py FOLDER

The channel is periodic, two fixed wedges narrow it, and an acceleration G
drives the flow: over the length L it holds the pressure rho G L against what
jams. From rest no disc gets faster than V = sqrt(2 G L), all of that pressure
made to speed. Where elastic bodies of that speed hit each other, the pressure
between them is at most rho V sqrt(E/rho) (Joukowsky), so that the fluid leaves
the film at sqrt(2 V sqrt(E/rho)) at most.
"""

import math
import os
import sys

import fsiCase
import results

CELLS = 40          # across the channel, 1 m
LENGTH = 3
RADIUS = 0.17
THROAT = 0.26
DRIVE = 10
MAX_SPEED = math.sqrt(2*DRIVE*LENGTH)

# Of the lower wedge; it reaches out of the channel
EDGE = 0.5 - THROAT/2
START, END = 1.4, 1.7
WEDGE = ((0.8, 0), (0.8, -0.1), (2.2, -0.1), (2.2, 0), (END, EDGE),
         (START, EDGE))

# Young's modulus over the pressure rho G L; stiffness of contact [Pa], if not E
RUNS = {"soft": (2, None), "soft, contact yields": (2, 0.01),
        "stiff": (100, None), "stiff, contact yields": (100, 0.01)}

SHAPES = """
lower
{{
    shape {{ type polygon; file "constant/lower.csv"; }}
    // E of a fixed body has no effect
    material {{ density 1; E 1; }}
    motion {{ type fixed; }}
}}
upper
{{
    $lower;
    shape {{ file "constant/upper.csv"; }}
}}
disc
{{
    shape {{ type circle; radius {0}; }}
    material {{ density 1; E {1}; }}
}}
"""
PLACEMENTS = """
wedges
{{
    type listed; shape lower;
    objects
    (
        {{ centre ({0} {1} 0); }}
        {{ centre ({0} {2} 0); shape upper; }}
    );
}}
discs
{{
    type listed; shape disc;
    objects ({{ centre (0.45 0.27 0); }} {{ centre (0.47 0.73 0); }});
}}
"""


def make(folder, name):
    """The case, seeded."""
    x, y = results.centroid(list(WEDGE))
    modulus, stiffness = RUNS[name]
    contact = (f"contact {{ law {{ stiffness {stiffness}; }} }}\n"
               if stiffness else "")
    case = fsiCase.Case(
        os.path.join(folder, name.replace(", ", "_").replace(" ", "_")),
        box=(0, 0, LENGTH, 1),
        cells=(LENGTH*CELLS, CELLS), cyclic="x", viscosity=0.1,
        shapes=SHAPES.format(RADIUS, modulus*DRIVE*LENGTH),
        placements=PLACEMENTS.format(x, y, 1 - y),
        properties="drivingForce { type acceleration; acceleration "
                   f"({DRIVE} 0 0); }}\n"
                   "output { objectsEvery 10; }\n" + contact,
        endTime=3, deltaT=0.005, adjustTimeStep="yes", maxCo=0.5,
        maxDeltaT=0.005, writeControl="adjustableRunTime", writeInterval=0.1)
    for wall, turn in (("lower", 0), ("upper", 1)):
        with open(os.path.join(case.path, f"constant/{wall}.csv"), "w",
                  encoding="ascii") as stream:
            stream.writelines(f"{px}, {1 - py if turn else py}\n"
                              for px, py in WEDGE)
    return case.set_up()


def solve(folder, name):
    """Makes and runs a case; its folder."""
    case = make(folder, name)
    case.run("fsiPisoFoam", limit=900)
    print(f"    {name}: {case.seconds['fsiPisoFoam']:.0f} s")
    return case.path


def disc_rows(case):
    """Rows of objects.csv, every ten steps."""
    return [r for r in results.table(case, "objects.csv")
            if r["shape"] == "disc"]


def passages(case):
    """Of each disc that gets through: when its centre enters the throat and
    when it leaves it, in order."""
    times = {}
    for row in disc_rows(case):
        inside, through = times.setdefault(row["object"], ([], []))
        if row["centroidX"] > END:
            through.append(row["time"])
        elif row["centroidX"] > START and not through:
            inside.append(row["time"])
    return sorted((min(inside), max(inside))
                  for inside, through in times.values() if through)


def width(case):
    """Least height of a disc at a written time, over its diameter."""
    least = 1
    for time in results.times(case):
        for shape, points, n in results.state(case, time).values():
            if shape == "disc":
                y = [p[1] for p in points[:n]]
                least = min(least, (max(y) - min(y))/(2*RADIUS))
    return least


def check(report, case, name):
    """The promises, and what the cells do."""
    rows = results.table(case, "global.csv")
    passed = passages(case)
    throat = ", ".join(f"{a:.2f} to {b:.2f} s" for a, b in passed) or "never"
    gap = min(r["smallestGap"] for r in disc_rows(case))*CELLS
    fastest = max(r["maxSpeed"] for r in rows)
    print(f"    {name}: in the throat {throat}; smallest gap {gap:.2f} h, "
          f"least height {width(case):.2f} of the diameter, largest speed "
          f"{fastest:.2f} m/s, area change "
          f"{max(r['areaChange'] for r in rows):.1e}, {len(rows)} steps")
    report.check(f"{name}: no disc is too fast", fastest < MAX_SPEED,
                 f"{fastest} m/s")
    wave = math.sqrt(RUNS[name][0]*DRIVE*LENGTH)
    film = max(math.sqrt(2*MAX_SPEED*wave), MAX_SPEED)
    try:
        fsiCase.run(case, "checkObjects", "-maxSpeed", f"{film}")
        report.check(f"{name}: no overlap, none leaves, none too fast", True)
    except RuntimeError as error:
        report.check(f"{name}: no overlap, none leaves, none too fast", False,
                     f"{error}")
    report.check(f"{name}: a gap is left in every step", gap > 0, f"{gap} h")
    if name.startswith("stiff"):
        report.check("stiff discs jam", not passed, f"{passed}")
        return
    report.check("both soft discs pass", len(passed) == 2, f"{passed}")
    report.check("one after the other",
                 len(passed) == 2 and passed[0][1] < passed[1][0], f"{passed}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for name in RUNS:
        case = report.attempt(f"run, {name}", solve, folder, name)
        if case:
            report.attempt(f"results, {name}", check, report, case, name)


if __name__ == "__main__":
    main(sys.argv[1])
