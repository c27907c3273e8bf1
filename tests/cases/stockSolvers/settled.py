#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks objects.csv of a disc that sinks in a stock solver's fluid.

    settled.py CASE LABEL

A disc of density ratio r = 2 that starts at rest falls less than one without
drag and added mass, (1 - 1/r) g t^2/2, and, before drag counts, more than
half of one with the added mass of a disc in an unbounded fluid,
(r - 1)/(r + 1) g t^2/2. Prints lines "ok NAME" and "FAIL NAME: reason".
"""

import csv
import math
import os
import sys

RATIO, GRAVITY, RADIUS, START = 2, 981, 0.125, (0.5, 1.0)


def report(name, passed, reason):
    """Prints the outcome of a check."""
    print(f"ok {name}" if passed else f"FAIL {name}: {reason}")


def main(case, label):
    """Checks the table of a case."""
    name = os.path.join(case, "postProcessing/fsiObjects/0/objects.csv")
    if not os.path.exists(name):
        report(f"{label} writes objects.csv", False, "no such file")
        return
    with open(name, encoding="utf-8") as table:
        rows = [{k: v if k == "shape" else float(v) for k, v in row.items()}
                for row in csv.DictReader(table)]
    times = [row["time"] for row in rows]
    report(f"{label} writes objects.csv",
           [round(t, 6) for t in times] == [0.02, 0.04, 0.06],
           f"times {times}")
    if not rows:
        return

    first, last = rows[0], rows[-1]
    fall = 0.5*GRAVITY*first["time"]**2
    low = 0.5*(RATIO - 1)/(RATIO + 1)*fall
    # The first step counts in full with implicit Euler
    high = (1 - 1/RATIO)*fall*(1 + 0.004/first["time"])
    fallen = START[1] - first["centroidY"]
    report(f"{label}: the disc sinks as it must", low < fallen < high,
           f"by {fallen}, not {low} to {high}")
    speeds = [-row["velocityY"] for row in rows]
    report(f"{label}: the disc gets faster, and less so",
           0 < speeds[1] - speeds[0] < speeds[0]
           and 0 < speeds[2] - speeds[1] < speeds[1] - speeds[0],
           f"speeds {speeds}")
    weight = (RATIO - 1)*math.pi*RADIUS**2*GRAVITY
    report(f"{label}: the fluid bears part of the weight",
           0.5*weight < last["forceY"] < weight,
           f"force {last['forceY']}, weight less buoyancy {weight}")
    drift = max(abs(row["centroidX"] - START[0]) for row in rows)
    report(f"{label}: the disc keeps to the middle", drift < 0.01,
           f"drift {drift}")
    change = max(abs(row["area"]/first["area"] - 1) for row in rows)
    change = max(change, abs(first["area"]/(math.pi*RADIUS**2) - 1) - 5e-3)
    report(f"{label}: the area is kept", change < 1e-6, f"change {change}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
