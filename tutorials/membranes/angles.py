#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Angles of the cells against time, from objects.csv, beside the theory of
Keller and Skalak for elliptic cylinders:

    angles.py OBJECTS_CSV ANGLES_CSV

ANGLES_CSV has a row per time: of each shape the inclination of its long axis
and the direction of its first membrane node, in degrees, without jumps.
"""

import csv
import math
import sys

# Semi-axes at rest, ratio of the viscosities and rate of shear, see
# system/seedObjectsDict
A, B = 0.1414, 0.0707
RATIO = {"equalViscosity": 1, "viscous": 20}
SHEAR = 1.0


def unwrapped(angles, period):
    """Angles [rad] in degrees, without jumps by the period."""
    result = [angles[0]]
    for angle in angles[1:]:
        turns = round((result[-1] - angle) / period)
        result.append(angle + turns*period)
    return [math.degrees(angle) for angle in result]


def theory(ratio):
    """Rate of the inclination is SHEAR/2 (strength cos(2 inclination) - 1);
    returns strength and the membrane's rate per cos(2 inclination)."""
    sum2, difference2 = A * A + B * B, A * A - B * B
    z = 0.5 * (A / B - B / A)
    tread = (A + B) ** 2 / (2 * z * (2 * A * B + ratio * sum2))
    return difference2 / sum2 + 4 * A * B / sum2 * tread, tread


def read(path):
    """Times, and of each shape its two angles."""
    times, cells = [], {}
    with open(path, encoding="utf-8") as table:
        for row in csv.DictReader(table):
            if not times or float(row["time"]) != times[-1]:
                times.append(float(row["time"]))
            cell = cells.setdefault(row["shape"], ([], []))
            cell[0].append(float(row["inclination"]))
            cell[1].append(float(row["phase"]))
    return times, {
        name: (unwrapped(c[0], math.pi), unwrapped(c[1], 2 * math.pi))
        for name, c in cells.items()
    }


def turning_time(times, values, turn):
    """Time of the last turn by so many degrees clockwise; nan if there was
    none [s]."""
    wanted = values[-1] + turn
    for i in range(len(times) - 1, 0, -1):
        if values[i - 1] >= wanted > values[i]:
            part = (values[i - 1] - wanted)/(values[i - 1] - values[i])
            start = times[i - 1] + part*(times[i] - times[i - 1])
            return times[-1] - start
    return math.nan


def report(name, times, inclination, phase):
    """Print what the cell does, and what theory says."""
    strength, tread = theory(RATIO[name])
    if strength > 1:
        angle = math.degrees(0.5*math.acos(1/strength))
        period = 2*math.pi/(SHEAR*tread/strength)
        print(f"{name}: inclination {inclination[-1]:.2f} degrees "
              f"(theory {angle:.2f}), the membrane's turn "
              f"{turning_time(times, phase, 360):.2f} s "
              f"(theory {period:.2f})")
    else:
        period = 2*math.pi/(SHEAR*math.sqrt(1 - strength**2))
        print(f"{name}: tumbles, half a turn "
              f"{turning_time(times, inclination, 180):.2f} s "
              f"(theory {period:.2f})")


def main():
    """Read, report, write."""
    times, cells = read(sys.argv[1])
    for name, angles in cells.items():
        report(name, times, *angles)
    with open(sys.argv[2], "w", encoding="utf-8", newline="") as table:
        writer = csv.writer(table, lineterminator="\n")
        writer.writerow(["time"] + [f"{name}{kind}" for name in cells
                                    for kind in ("Inclination", "Phase")])
        for i, time in enumerate(times):
            writer.writerow([time] + [f"{column[i]:.4f}"
                                      for cell in cells.values()
                                      for column in cell])


if __name__ == "__main__":
    main()
