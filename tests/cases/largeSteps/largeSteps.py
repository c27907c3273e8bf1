#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps of hundreds of viscous times h^2/nu of a cell.

    largeSteps.py FOLDER

The velocity is as smooth as with a fifth of the step: no cell at an object is
left behind by, or thrown out of, the flow around it (doc/theory.md, (4.10)).
The tutorial redCells with elastic bodies, which have walls; how far a cell of
the fluid is from the mean of its neighbours, the largest of all cells, in the
mean over all written times.

A steady flow does not depend on the step ((4.12)): driven cavity without
inertia, smallest velocity on its middle line; array of fixed discs that a force
drives the fluid through, mean velocity.

A film that fixed plates close off has no pressure but rounding errors: it does
nothing to the channel between them.

Objects in a cavity whose lid moves are not faster than it where a step is up to
a hundred thousand viscous times: starts of passes lie hundreds of changes ahead
there, and pressure and links of a node are thousands of times what it resists.
Rigid and stiff ones stay below half of the lid's speed, as the fluid there.

And tolerances, see tolerances.py, and the pressure with membranes, see
pressure.py.
"""

import math
import os
import re
import sys

import fsiCase
import pressure
import results
import tolerances

STEP, EVERY, END = 5e-5, 5e-4, 4e-3
NX, NY = 120, 40

ELASTIC = "material { density 1100; E 30; } minimumCells 1.2;"

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
    path = os.path.join(case, "system/seedObjectsDict")
    with open(path, encoding="ascii") as stream:
        text = re.sub(r"material\s*\{[^}]*\}", ELASTIC, stream.read())
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)
    fsiCase.run(case, "seedObjects")
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


def array(folder, step, n, scheme="Euler"):
    """Mean velocity through an array of fixed discs after n steps."""
    case = fsiCase.Case(
        os.path.join(folder, f"array-{step}"), cells=(32, 32), viscosity=1,
        cyclic="xy", time_scheme=scheme,
        shapes="disc { shape { type circle; radius 0.35; } "
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
    other = array(folder, 5e-4, 400, "backward")
    report.check("nor on the rule in time", abs(other/small - 1) < 0.001,
                 f"{other}, not {small}")


def channel(folder, behind):
    """Velocities in a channel between fixed plates that go on through cyclic
    patches; the upper one ends this far from a wall."""
    halves = {"low": 4, "high": (16 - behind - 7.33)/2}
    middles = {"low": 5.33 - halves["low"], "high": 7.33 + halves["high"]}
    plate = ("shape {{ type polygon; file \"{0}.csv\"; }} "
             "material {{ type rigid; density 1; }} motion {{ type fixed; }}")
    case = fsiCase.Case(
        os.path.join(folder, f"channel-{behind}"), box=(0, 0, 4, 16),
        cells=(4, 16), viscosity=1, cyclic="x",
        shapes=" ".join(f"{name} {{ {plate.format(name)} }}"
                        for name in halves),
        placements="".join(
            f"{name} {{ type listed; shape {name}; minimumGap 0; wallGap 0; "
            f"objects ({{ centre (2 {y} 0); }}); }}"
            for name, y in middles.items()),
        properties="drivingForce { type acceleration; "
                   "acceleration (1 0 0); }",
        deltaT=1, endTime=40, writeInterval=40)
    for name, half in halves.items():
        corners = ((-8, -half), (8, -half), (8, half), (-8, half))
        with open(os.path.join(case.path, name + ".csv"), "w",
                  encoding="ascii") as stream:
            stream.writelines(f"{x},{y}\n" for x, y in corners)
    case.set_up()
    case.run("fsiPisoFoam")
    iterations = max(map(int, re.findall(r" p (\d+)", results.read(
        case.path, "log.fsiPisoFoam"))))
    u = results.field(case.path, results.times(case.path)[-1], "U")
    return u[3*4*5:3*4*8], iterations


def check_closed(report, folder):
    """With a film of some thickness behind a plate, and without."""
    alone, _ = channel(folder, -1)
    for behind in (0.5, 0.67, 1.67):
        beside, iterations = channel(folder, behind)
        report.check(f"a closed film of {behind} leaves the channel alone",
                     max(alone) > 0.3 and max(
                         abs(a - b) for a, b in zip(alone, beside)) < 1e-6,
                     f"velocities {beside}, not {alone}")
        report.check("its pressure takes no iterations", iterations < 10,
                     f"{iterations}")


# Name, cells, viscosity (dt nu/h^2 is 1e5 in all cases but the soft sphere's,
# with 2560), material, largest speed over the lid's
LID = (
    ("soft disc", (24, 24), 17361, "density 1.5; E 20;", 1),
    ("light soft disc", (24, 24), 17361, "density 0.1; E 20;", 1),
    ("stiff disc", (24, 24), 17361, "density 1.5; E 1e6;", 0.5),
    ("soft sphere", (16, 16, 16), 1000, "density 1.5; E 20;", 1),
    ("stiff sphere", (16, 16, 16), 39063, "density 1.5; E 1e6;", 0.5),
    ("rigid sphere", (16, 16, 16), 39063, "type rigid; density 1.5;", 0.5),
    ("light rigid sphere", (16, 16, 16), 39063, "type rigid; density 0.1;",
     0.5))


def check_lid(report, folder):
    """Largest speed of a node."""
    for name, cells, viscosity, material, most in LID:
        plane = len(cells) == 2
        kind, centre = ("circle", ".35 .35 0") if plane else (
            "sphere", ".3 .3 .3")
        case = fsiCase.Case(
            os.path.join(folder, name.replace(" ", "-")),
            box=(0, 0, 1, 1) if plane else (0, 0, 0, 1, 1, 1), cells=cells,
            viscosity=viscosity, walls={"top": "(1 0 0)"}, density=1,
            shapes=f"a {{ shape {{ type {kind}; radius "
                   f"{0.2 if plane else 0.15}; }} "
                   f"material {{ {material} }} }}",
            placements="p { type listed; shape a; "
                       f"objects ({{ centre ({centre}); }}); }}",
            deltaT=0.01, endTime=0.05).set_up()
        if not report.attempt(name, case.run, "fsiPisoFoam"):
            continue
        speeds = [row["maxSpeed"]
                  for row in results.table(case.path, "global.csv")]
        report.check(f"a {name} at large steps is below {most} of the lid's"
                     " speed",
                     len(speeds) == 5 and 0.01 < max(speeds) < most,
                     f"speeds {speeds}")


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
    report.attempt("closed film", check_closed, report, folder)
    report.attempt("driven cavity", check_lid, report, folder)
    report.attempt("pressure", pressure.check, report, folder)
    report.attempt("tolerances", tolerances.check, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
