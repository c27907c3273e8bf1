#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Order in time of the schemes of ddt(U) (doc/theory.md, (4.15)).

    timeOrder.py FOLDER

Vortices of two wave numbers in a box of cyclic sides, without objects, so that
they convect each other while they decay. The mesh is one and the same: the
differences between steps that are halved are errors in time alone. All
equations are solved to the end: five sweeps of (4.10) leave a small error of
first order.
"""

import math
import os
import sys

import fsiCase
import results

CELLS = 32
VISCOSITY = 0.02
END = 1
STEPS = (40, 80, 160)


def start(x, y):
    """Velocity at the start: free of divergence."""
    k = 2*math.pi
    return (math.sin(k*x)*math.cos(k*y) + 0.5*math.sin(2*k*y),
            -math.cos(k*x)*math.sin(k*y) + 0.3*math.sin(k*x), 0)


def make(folder, scheme, n, every=None):
    """A case with n steps, written at the end or every so many, set up."""
    case = fsiCase.Case(
        os.path.join(folder, f"{scheme}-{n}"), cells=(CELLS, CELLS),
        viscosity=VISCOSITY, cyclic="xy", time_scheme=scheme,
        p_tolerance=1e-11, U_tolerance=1e-11,
        U_controls="responseTolerance 1e-6; responseMaxIter 100;",
        properties="coupling { type solidImplicit; passes 1; }",
        deltaT=END/n, endTime=END, writePrecision=17,
        writeInterval=every or n)
    h = 1/CELLS
    cells = [start((i % CELLS + 0.5)*h, (i//CELLS + 0.5)*h)
             for i in range(CELLS*CELLS)]
    path = os.path.join(case.path, "0/U")
    with open(path, encoding="ascii") as stream:
        text = stream.read()
    old = "internalField uniform (0 0 0);"
    if old not in text:
        raise ValueError(f"{path} has no '{old}'")
    values = "\n".join("({!r} {!r} {!r})".format(*u) for u in cells)
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text.replace(
            old, "internalField nonuniform List<vector>\n"
            f"{len(cells)}\n(\n{values}\n);"))
    return case.set_up()


def velocity(case):
    """Velocity of all cells at the end."""
    return results.field(case.path, results.times(case.path)[-1], "U")


def distance(a, b):
    """Root mean square of a difference."""
    return math.sqrt(sum((x - y)**2 for x, y in zip(a, b))/len(a))


def order(folder, scheme):
    """Observed order of three steps, and the difference of the last two."""
    found = []
    for n in STEPS:
        case = make(folder, scheme, n)
        case.run("fsiPisoFoam")
        found.append(velocity(case))
    coarse, fine = (distance(a, b) for a, b in zip(found, found[1:]))
    return math.log2(coarse/fine), fine


def check_restart(report, folder):
    """A run in two parts ends as one in one part."""
    whole = make(folder, "backward", STEPS[0])
    whole.run("fsiPisoFoam")
    one = velocity(whole)
    parts = make(folder, "backward", STEPS[0], STEPS[0]//2)
    parts.control(endTime=END/2)
    parts.run("fsiPisoFoam")
    parts.control(endTime=END, startFrom="latestTime")
    parts.run("fsiPisoFoam")
    report.check("a restart goes on with the same rule",
                 distance(one, velocity(parts)) < 1e-10,
                 f"{distance(one, velocity(parts))}")
    middle = os.path.join(parts.path, f"{END/2:g}")
    report.check("old fields are written",
                 all(os.path.exists(os.path.join(middle, name))
                     for name in ("U_0", "phi_0")), middle)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    found = {}
    for scheme in ("Euler", "backward"):
        found[scheme] = report.attempt(scheme, order, folder, scheme)
        if found[scheme]:
            print("    {}: order {:.2f}, difference {:.2e}".format(
                scheme, *found[scheme]))
    if None in found.values():
        return
    report.check("Euler is of first order",
                 abs(found["Euler"][0] - 1) < 0.2, f"{found}")
    report.check("backward is of second order",
                 found["backward"][0] >= 1.8, f"{found}")
    report.check("and nearer with the same steps",
                 found["backward"][1] < 0.3*found["Euler"][1], f"{found}")
    report.attempt("restart", check_restart, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
