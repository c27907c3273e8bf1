#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps of hundreds of viscous times h^2/nu of a cell.

    largeSteps.py FOLDER

The velocity is as smooth as with a fifth of the step: no cell at an object is
left behind by, or thrown out of, the flow around it (doc/theory.md, (4.10)).
The tutorial redCells; how far a cell of the fluid is from the mean of its
neighbours, the largest of all cells, in the mean over all written times.

A steady flow does not depend on the step ((4.12)): driven cavity without
inertia, smallest velocity on its middle line; array of fixed discs that a force
drives the fluid through, mean velocity.
"""

import math
import os
import sys

import fsiCase
import results

STEP, EVERY, END = 5e-5, 5e-4, 4e-3
NX, NY = 120, 40

# Mean velocity of the tutorial, and how much rougher the large steps may be:
# as the largest cell differs from time to time by up to a third, a half
MEAN, ROUGHER = 1e-3, 1.5


def roughness(case, time):
    """Largest difference of a fluid cell from its neighbours' mean [m/s]."""
    flat = results.field(case, time, "U")
    distance = results.field(case, time, "signedDistance")
    u = [(flat[3*i], flat[3*i + 1]) for i in range(NX*NY)]
    largest = 0
    for j in range(1, NY - 1):
        for i in range(NX):
            cell = i + NX*j
            if distance[cell] <= 0:
                continue
            around = (u[(i + 1) % NX + NX*j], u[(i - 1) % NX + NX*j],
                      u[cell + NX], u[cell - NX])
            mean = [sum(v[d] for v in around)/4 for d in (0, 1)]
            largest = max(largest, math.dist(u[cell], mean))
    return largest


def solve(case, step):
    """Runs the tutorial; its mean roughness over the written times."""
    fsiCase.tutorial("redCells", case, endTime=END, deltaT=step,
                     maxDeltaT=step, writeInterval=EVERY, writeFormat="ascii")
    fsiCase.run(case, "fsiPisoFoam")
    times = results.times(case)[1:]
    return sum(roughness(case, t) for t in times)/len(times), len(times)


def cavity(folder, viscosity, step):
    """Smallest velocity along the lid on the middle line after 1000 steps."""
    case = fsiCase.Case(
        os.path.join(folder, f"cavity-{viscosity}"), walls={"top": "(1 0 0)"},
        viscosity=viscosity, deltaT=step, endTime=1000*step,
        writeControl="timeStep", writeInterval=1000).set_up()
    case.run("fsiPisoFoam")
    u = results.field(case.path, results.times(case.path)[-1], "U")
    n = round(math.sqrt(len(u)/3))
    return min(u[3*(n*j + n//2)] for j in range(n))


def check_steady(report, folder):
    """dt nu/h^2 of 1 and of 100."""
    small, large = cavity(folder, 1, 1e-3), cavity(folder, 10, 1e-2)
    report.check("a steady flow does not depend on the step",
                 small < -0.2 and abs(large/small - 1) < 0.005,
                 f"{large}, not {small}")


def array(folder, step, n):
    """Mean velocity through an array of fixed discs after n steps."""
    case = fsiCase.Case(
        os.path.join(folder, f"array-{step}"), cells=(32, 32), viscosity=1,
        cyclic="xy", shapes="disc { shape { type circle; radius 0.35; } "
        "material { density 1; E 1e3; } motion { type fixed; } }",
        placements="a { type listed; shape disc; "
                   "objects ({ centre (0.47 0.52 0); }); }",
        properties="drivingForce { type acceleration; "
                   "acceleration (12 4 0); }",
        deltaT=step, endTime=n*step, writeControl="timeStep",
        writeInterval=n).set_up()
    case.run("fsiPisoFoam")
    u = results.field(case.path, results.times(case.path)[-1], "U")
    return 3*sum(u[::3])/len(u)


def check_array(report, folder):
    """dt nu/h^2 of 0.5 and of 100: 0.7 % where fluxes of cut faces hold the
    step's gradients."""
    small, large = array(folder, 5e-4, 400), array(folder, 0.1, 200)
    report.check("a steady flow around walls does not depend on the step",
                 small > 0.06 and abs(large/small - 1) < 0.001,
                 f"{large}, not {small}")


def check_smooth(report, folder):
    """No cell out of the flow around it."""
    large, n_large = solve(os.path.join(folder, "large"), STEP)
    small, n_small = solve(os.path.join(folder, "small"), STEP/5)
    report.check("both run to their end", n_large == n_small == 8,
                 f"{n_large}, {n_small} times")
    report.check("large steps leave the velocity smooth",
                 0 < large < ROUGHER*small,
                 f"{large/MEAN} and {small/MEAN} of the mean velocity")
    print(f"    a cell differs from its neighbours by up to {large/MEAN:.2f}, "
          f"with a fifth of the step {small/MEAN:.2f} of the mean velocity")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("smooth velocity", check_smooth, report, folder)
    report.attempt("steady flow", check_steady, report, folder)
    report.attempt("steady flow around walls", check_array, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
