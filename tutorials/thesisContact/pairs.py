#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of heavy discs that collide in a fluid: makes the cases, compares them.

    pairs.py case LAW FLUID     cases/LAW-FLUID; FLUID is fluid or noFluid
    pairs.py table              table.md from what was run

Nine pairs, each by itself: three speeds, three distances of the paths. A pair
is compared when its discs come nearer than NEAR cells and when they are farther
apart again, or at the end: the laws act from 3 and from 4 cells on.
"""

import math
import os
import sys

import fsiCase
import results

CELLS_PER_METRE = 64
RADIUS = 0.08
DENSITY, DISC_DENSITY = 1000, 1e4
MODULUS = 5e4
END = 2
MAX_STEP = 0.002

# Of each disc [m/s], along x, and the distance of the centres along x at the
# start [m]; distance of the paths over the diameter
SPEEDS = {0.05: 0.25, 0.15: 0.3, 0.5: 0.35}
OFFSETS = (0, 0.3, 0.6)

# Part of the box of a pair [m]
ROOM = (0.75, 0.5)

# Gap at which a collision begins and ends [h]
NEAR = 4.5

FOLDER = "cases"

PRESET = '#include "$FSI_PROJECT_DIR/etc/caseDicts/thesis"\n'
CONTACT = '#include "$FSI_PROJECT_DIR/etc/caseDicts/thesisContact"\n'

# Name of a case: its entries of fsiProperties, and how the table names it
LAWS = {
    "default": ("", "default"),
    "thesis": (CONTACT, "thesis, `stiffness` E = 50 kPa"),
    "thesisSoft": (CONTACT + "contact { law { stiffness 225; } }\n",
                   "thesis, `stiffness` rho_s U^2 = 225 Pa at 0.15 m/s"),
    "preset": (PRESET, "all of the thesis's choices"),
    "presetElastic": (
        PRESET + "contact { search { type surfaceTree; } "
        "law { type elastic; } }\n",
        "all of the thesis's choices but contact"),
    "defaultHeavy": ("", "discs 10 times as heavy and stiff: default"),
    "presetHeavy": (PRESET, "the same, all of the thesis's choices"),
    "presetHeavySoft": (
        PRESET + "contact { law { stiffness 2250; } }\n",
        "the same, `stiffness` rho_s U^2 = 2250 Pa"),
}

NAMES = {"fluid": "fluid", "noFluid": "no fluid"}

SHAPES = """
disc
{{
    shape {{ type circle; radius {}; }}
    material {{ density {}; E {}; }}
    admm {{ scheme {}; }}
}}
"""


def places():
    """Entries of the discs: pair i is the objects 2 i and 2 i + 1."""
    entries = []
    for row, offset in enumerate(OFFSETS):
        for column, (speed, apart) in enumerate(SPEEDS.items()):
            for side in (-1, 1):
                x = (column + 0.5)*ROOM[0] + side*apart/2
                y = (row + 0.5)*ROOM[1] + side*offset*RADIUS
                entries.append(f"{{ centre ({x} {y} 0); "
                               f"velocity ({-side*speed} 0 0); }}")
    return "\n".join(entries)


def make(law, fluid):
    """Writes a case."""
    factor = 10 if "Heavy" in law else 1
    coupling = {"fluid": "", "noFluid": "coupling { type none; }\n"}[fluid]
    size = [n*length for n, length in zip((len(SPEEDS), len(OFFSETS)), ROOM)]
    case = fsiCase.Case(
        os.path.join(FOLDER, f"{law}-{fluid}"), box=(0, 0, *size),
        cells=tuple(round(CELLS_PER_METRE*length) for length in size),
        viscosity=2e-4, density=DENSITY,
        shapes=SHAPES.format(
            RADIUS, factor*DISC_DENSITY, factor*MODULUS,
            "ADMM" if law.startswith("preset") else "quasiNewton"),
        placements="discs { type listed; shape disc; "
                   f"objects ({places()}); }}",
        properties=LAWS[law][0] + coupling + "output { objectsEvery 1; }\n",
        endTime=END, deltaT=MAX_STEP, adjustTimeStep="yes", maxCo=0.5,
        maxDeltaT=MAX_STEP, writeControl="adjustableRunTime", writeInterval=0.2)
    print(case.path)


def energy(row):
    """Kinetic energy of a disc as a rigid body, per metre [J/m]."""
    mass = DISC_DENSITY*math.pi*RADIUS**2
    return 0.5*mass*(speed(row)**2
                     + 0.5*(RADIUS*row["angularVelocityZ"])**2)


def speed(row):
    """Of the centre of mass."""
    return math.hypot(row["velocityX"], row["velocityY"])


def gap(one, other):
    """Between two round discs, in cells."""
    distance = math.hypot(one["centroidX"] - other["centroidX"],
                          one["centroidY"] - other["centroidY"])
    return (distance - 2*RADIUS)*CELLS_PER_METRE


def collisions(case):
    """Of each pair that meets: rows of its discs in each step from before to
    after the collision, and whether it ended."""
    steps = {}
    for row in results.table(case, "objects.csv"):
        steps.setdefault(row["time"], {})[int(row["object"])] = row
    found = []
    for pair in range(len(SPEEDS)*len(OFFSETS)):
        rows = [(s[2*pair], s[2*pair + 1]) for _, s in sorted(steps.items())]
        near = [gap(*discs) < NEAR for discs in rows]
        if True not in near:
            continue
        first = near.index(True)
        ended = False in near[first:]
        last = near.index(False, first) if ended else len(near) - 1
        found.append((rows[first:last + 1], ended))
    return found


def state(case):
    """What checkObjects found."""
    text = results.read(case, "log.checkObjects")
    return "sound" if "Objects are sound" in text else "faults"


def collision_columns(met):
    """Columns of the table that tell what collisions did."""
    if not met:
        return "| none met | | | | "
    before = [speed(r) for rows, _ in met for r in rows[0]]
    mean = sum(before)/len(before)
    slow = sum(speed(r) < 0.01*mean for rows, _ in met for r in rows[-1])
    energies = [[sum(map(energy, discs)) for discs in rows] for rows, _ in met]
    change = [e[-1]/e[0] - 1 for e in energies]
    most = max(max(e)/e[0] - 1 for e in energies)
    return (f"| {sum(not ended for _, ended in met)} "
            f"| {100*slow/len(before):.0f} % "
            f"| {100*sum(change)/len(change):+.3g} % "
            f"| {100*max(change):+.3g} % "
            f"| {100*most:+.3g} % ")


def line(law, fluid):
    """A row of the table."""
    case = os.path.join(FOLDER, f"{law}-{fluid}")
    steps = results.table(case, "global.csv")
    deltas = sorted(r["deltaT"] for r in steps)
    return (f"| {LAWS[law][1]}, {NAMES[fluid]} "
            f"{collision_columns(collisions(case))}"
            f"| {max(r['maxSpeed'] for r in steps):.3g} m/s "
            f"| {1000*deltas[0]:.3g} ms, {deltas[0]/MAX_STEP:.3g} "
            f"| {steps[-1]['time']:.2f} s | {state(case)} |")


def table():
    """Writes table.md from all cases that were run."""
    lines = [
        "| contact | pairs of 9 that do not part "
        "| discs slower than 1 % of the mean after contact "
        "| change of a pair's kinetic energy by contact, mean | largest "
        "| the same during contact, largest "
        "| fastest node | smallest step, over the largest allowed | ran to "
        "| checkObjects |",
        "|" + 10*"---|",
    ] + [line(law, fluid) for fluid in NAMES for law in LAWS
         if os.path.isdir(f"{FOLDER}/{law}-{fluid}")]
    with open("table.md", "w", encoding="ascii") as stream:
        stream.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    {"case": make, "table": table}[sys.argv[1]](*sys.argv[2:])
