#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc that starts with a velocity in a periodic fluid at rest.

    started.py make CASE           lets the sides of the case be cyclic
    started.py check CASE LABEL    looks at the momentum after the run

What the disc loses the fluid around it gets: nothing else has a momentum.
Prints lines "ok NAME" and "FAIL NAME: reason".
"""

import csv
import math
import os
import re
import sys

from settled import RADIUS, RATIO, report

SPEED, SIDES = 4, (32, 48)

PAIRS = {"left": ("right", "(0 4 7 3)"), "right": ("left", "(1 2 6 5)"),
         "bottom": ("top", "(0 1 5 4)"), "top": ("bottom", "(3 7 6 2)")}


def change(name, pattern, text):
    """Replaces what a pattern matches in a file."""
    with open(name, encoding="ascii") as stream:
        old = stream.read()
    new = re.sub(pattern, text, old, flags=re.DOTALL)
    assert new != old, name
    with open(name, "w", encoding="ascii") as stream:
        stream.write(new)


def make(case):
    """Cyclic sides, no gravity, and a disc with a velocity."""
    change(os.path.join(case, "system/blockMeshDict"), r"walls\s*\{.*?\}",
           " ".join(f"{name} {{ type cyclic; neighbourPatch {other}; "
                    f"faces ({face}); }}"
                    for name, (other, face) in PAIRS.items()))
    for field in "Up":
        change(os.path.join(case, "0", field), r"walls\s*\{.*?\}",
               " ".join(f"{name} {{ type cyclic; }}" for name in PAIRS))
    change(os.path.join(case, "constant/fsiProperties"), r"gravity[^;]*;",
           "gravity (0 0 0);")
    change(os.path.join(case, "system/seedObjectsDict"),
           r"centre \(0.5 1 0\);", rf"\g<0> velocity ({SPEED} 0 0);")


def check(case, label):
    """Momentum of the last written time."""
    name = os.path.join(case, "postProcessing/fsiObjects/0/objects.csv")
    with open(name, encoding="utf-8") as table:
        last = list(csv.DictReader(table))[-1]
    with open(os.path.join(case, f"{float(last['time']):g}", "U"),
              encoding="ascii") as stream:
        values = re.findall(r"\((\S+) \S+ \S+\)",
                            stream.read().split("boundaryField")[0])
    cell = 1.5/(SIDES[0]*SIDES[1])
    fluid = sum(map(float, values))*cell
    disc = math.pi*RADIUS**2
    momentum = fluid + (RATIO - 1)*disc*float(last["velocityX"])
    part = momentum/(RATIO*disc*SPEED)
    report(f"{label}: what a disc loses at its start the fluid gets",
           len(values) == SIDES[0]*SIDES[1] and abs(part - 1) < 0.03,
           f"{part} of the momentum is left")


if __name__ == "__main__":
    if sys.argv[1] == "make":
        make(sys.argv[2])
    else:
        check(*sys.argv[2:])
