#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lid-driven cavity at Re 100 without objects against Ghia, Ghia and Shin
(1982): profiles on the centre lines, ghia.csv.

    profiles.py FOLDER CELLS [PROPERTIES]
"""

import csv
import os
import sys

import fsiCase
import results

# Of the lid's speed, rms over the points of both profiles
TOLERANCE = 1e-2


def solve(folder, n, properties):
    """Runs the case to a steady state; the velocities, row after row."""
    case = fsiCase.Case(
        os.path.join(folder, "case"), cells=(n, n), viscosity=0.01,
        walls={"top": "(1 0 0)"}, properties=properties,
        deltaT=0.8/n, endTime=16, writeInterval=round(20*n/5),
    ).set_up()
    case.run("fsiPisoFoam", limit=2000)
    print(f"    CPU time {case.seconds['fsiPisoFoam']:.0f} s")
    fields = []
    for time in results.times(case.path)[-2:]:
        flat = results.field(case.path, time, "U")
        fields.append((float(time), flat[0::3], flat[1::3]))
    return fields


def profile(n, value, first, last):
    """Points (s, value) along a centre line, with the walls' values;
    value(across, along) is that of a cell."""
    middle = (n//2 - 1, n//2)
    return ([(0, first)]
            + [((j + 0.5)/n, sum(value(i, j) for i in middle)/2)
               for j in range(n)]
            + [(1, last)])


def at(points, s):
    """Linear interpolation."""
    for (a, va), (b, vb) in zip(points, points[1:]):
        if a <= s <= b:
            return va + (vb - va)*(s - a)/(b - a)
    raise ValueError(f"{s} is not on the line")


def main(folder, n, properties=""):  # properties: more of fsiProperties
    """The checks."""
    report = fsiCase.Report()
    fields = report.attempt("cavity without objects runs", solve, folder, n,
                            properties)
    if fields is None:
        return
    (_, u0, _), (_, u, v) = fields
    change = max(abs(a - b) for a, b in zip(u0, u))
    report.check("the flow is steady", change < 1e-3,
                 f"it changes by {change:.1e}")

    lines = {
        "u": profile(n, lambda i, j: u[i + n*j], 0, 1),
        "v": profile(n, lambda j, i: v[i + n*j], 0, 0),
    }
    with open("ghia.csv", encoding="ascii") as stream:
        rows = list(csv.DictReader(stream))
    errors = {c: [at(lines[c], float(r["position"])) - float(r["value"])
                  for r in rows if r["component"] == c] for c in lines}
    total = [e for c in errors.values() for e in c]
    for name, e in (*errors.items(), ("u and v", total)):
        rms = (sum(x*x for x in e)/len(e))**0.5
        print(f"    {name}: rms {rms:.2e} over {len(e)} points")
        report.check(f"profiles of {name}", len(e) > 10 and rms <= TOLERANCE,
                     f"rms {rms:.2e}")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), *sys.argv[3:])
