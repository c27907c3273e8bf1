#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The load of the fluid on a disc goes on in a restart and beyond a feed.

    restarted.py make CASE           opens the left and right sides of the case
    restarted.py feed CASE           adds a feed that begins within the run
    restarted.py restart CASE        lets the case go on to its end
    restarted.py check WHOLE OTHER LABEL    compares the disc that sinks

Prints lines "ok NAME" and "FAIL NAME: reason".
"""

import csv
import glob
import os
import sys

from settled import report
from started import change

PATCHES = """
    left { type patch; faces ((0 4 7 3)); }
    right { type patch; faces ((1 2 6 5)); }
    walls { type wall; faces ((0 1 5 4) (3 7 6 2)); }"""

# The right side gives the pressure
CONDITIONS = {
    "U": "left { type fixedValue; value uniform (10 0 0); } "
         "right { type zeroGradient; } walls { type noSlip; }",
    "p": "left { type zeroGradient; } "
         "right { type fixedValue; value uniform 0; } "
         "walls { type zeroGradient; }"}

FEED = """
boundaries { feed { left { shape disc; rate 1; startTime 0.0239;
    velocity (10 0 0); randomRotation no; seed 1; } } }
"""


def make(case):
    """Open sides, a line of objects.csv for each step, all digits."""
    change(os.path.join(case, "system/blockMeshDict"), r"walls\s*\{.*?\}",
           PATCHES)
    for field, text in CONDITIONS.items():
        change(os.path.join(case, "0", field), r"walls\s*\{.*?\}", text)
    change(os.path.join(case, "system/controlDict"), r"writePrecision[^;]*;",
           "writePrecision 17;")
    with open(os.path.join(case, "constant/fsiProperties"), "a",
              encoding="ascii") as stream:
        stream.write("output { objectsEvery 1; }\n")


def feed(case):
    """Objects come in from the seventh step on."""
    with open(os.path.join(case, "constant/fsiProperties"), "a",
              encoding="ascii") as stream:
        stream.write(FEED)


def restart(case):
    """From the last written time."""
    change(os.path.join(case, "system/controlDict"), r"startFrom[^;]*;",
           "startFrom latestTime;")
    change(os.path.join(case, "system/controlDict"), r"endTime  [^;]*;",
           "endTime 0.06;")


def fall(case):
    """Velocity of the first object at each time, restarts included."""
    speeds = {}
    for name in sorted(glob.glob(os.path.join(
            case, "postProcessing/fsiObjects/*/objects.csv"))):
        with open(name, encoding="utf-8") as table:
            for row in csv.DictReader(table):
                if int(row["object"]) == 0:
                    speeds[round(float(row["time"]), 6)] = float(
                        row["velocityY"])
    return speeds


def check(whole, other, label):
    """The same speeds at all times of the first one."""
    one, two = fall(whole), fall(other)
    largest = max(map(abs, one.values()))
    off = max(abs(one[t] - two.get(t, 1e9)) for t in one)/largest
    report(label, len(one) > 5 and off < 1e-6,
           f"{off} of {largest} apart, {len(one)} and {len(two)} times")


if __name__ == "__main__":
    {"make": make, "feed": feed, "restart": restart, "check": check}[
        sys.argv[1]](*sys.argv[2:])
