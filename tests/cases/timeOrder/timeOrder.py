#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Order in time of the schemes of ddt(U) (doc/theory.md, (4.15)).

    timeOrder.py FOLDER

Vortices of two wave numbers in a box of cyclic sides, without objects, so that
they convect each other while they decay. The mesh is one and the same: the
differences between steps that are halved are errors in time alone.

A disc that nearly fills half of a channel, from rest: the mean velocity after
a tenth of the viscous time. The equations of a step are solved to the end, by
many passes. The error is what the velocity differs from that with 320 steps;
dt nu/h^2 is 2.6, 1.3 and 0.3.

A run with a disc in two parts ends as one in one part. Discs that collide get
no faster. What is of first order is refused.
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

# The disc in the channel
DISC_END = 0.1
DISC_STEPS = (40, 80, 320)
BODIES = {
    "soft": "E 300;",
    "stiff": "E 1e6;",
    "rigid": "type rigid;",
}


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


def disc(folder, name, material, scheme, n, every=None, coupling=""):
    """A disc in a channel with n steps to a tenth of the viscous time."""
    return fsiCase.Case(
        os.path.join(folder, f"{name}-{scheme}-{n}"), cells=(CELLS, CELLS),
        viscosity=1, cyclic="x", time_scheme=scheme,
        p_tolerance=1e-10, U_tolerance=1e-10,
        shapes="disc { shape { type circle; radius 0.25; } "
               f"material {{ density 1; {material} }} }}",
        placements="all { type listed; shape disc; "
                   "objects ({ centre (0.5 0.35 0); }); }",
        properties=fsiCase.THESIS
                   + "drivingForce { type acceleration; "
                   "acceleration (12 0 0); } contact { range 1; } coupling { "
                   + (coupling or "type solidImplicit; passes 30; "
                      "passTolerance 1e-7;") + " }",
        deltaT=DISC_END/n, endTime=DISC_END, writeInterval=every or n,
        writePrecision=17, timePrecision=12).set_up()


def disc_order(folder, name, material, scheme):
    """Order of the mean velocity from the errors of two steps, and the error
    of the smaller one."""
    found = []
    for n in DISC_STEPS:
        case = disc(folder, name, material, scheme, n)
        case.run("fsiPisoFoam")
        found.append(sum(velocity(case)[::3])/CELLS**2)
    coarse, fine = (abs(a - found[-1]) for a in found[:-1])
    print(f"    {name}, {scheme}: order {math.log2(coarse/fine):.2f}, "
          f"error {fine:.2e} of {found[-1]:.4f}")
    return math.log2(coarse/fine), fine


def check_bodies(report, folder):
    """All kinds of body that are of second order."""
    _, euler = disc_order(folder, "rigid", BODIES["rigid"], "Euler")
    for name, material in BODIES.items():
        found, fine = disc_order(folder, name, material, "backward")
        report.check(f"a {name} disc is of second order", found >= 1.8,
                     f"{found}")
        if name == "rigid":
            report.check("and nearer than with Euler", fine < 0.3*euler,
                         f"{fine}, Euler {euler}")


def check_disc_restart(report, folder):
    """As check_restart, with a soft disc."""
    n = DISC_STEPS[0]
    whole = disc(folder, "whole", BODIES["soft"], "backward", n)
    whole.run("fsiPisoFoam")
    parts = disc(folder, "parts", BODIES["soft"], "backward", n, n//2)
    parts.control(endTime=DISC_END/2)
    parts.run("fsiPisoFoam")
    parts.control(endTime=DISC_END, startFrom="latestTime")
    parts.run("fsiPisoFoam")
    difference = distance(velocity(whole), velocity(parts))
    report.check("a restart with a disc goes on with the same rule",
                 difference < 1e-8, f"{difference}")


def refusal(case):
    """The message with which a run ends, empty if it does not."""
    try:
        case.run("fsiPisoFoam")
    except RuntimeError as error:
        return str(error)
    return ""


def check_refusals(report, folder):
    """Schemes, materials and couplings that are of first order only."""
    for name, material, scheme, coupling, words in (
            ("scheme", "E 300;", "CrankNicolson", "",
             ("CrankNicolson", "Euler or backward")),
            ("material", "E 300; viscosity 1;", "backward", "",
             ("viscosity", "Euler")),
            ("coupling", "E 300;", "backward", "type weak;",
             ("weak", "solidImplicit"))):
        message = refusal(disc(folder, name, material, scheme, DISC_STEPS[0],
                               coupling=coupling))
        report.check(f"a {name} of first order is refused",
                     all(word in message for word in words), message)


def check_collision(report, folder):
    """Two discs meet without a fluid, in steps of 0.4 cells: contact acts from
    where they were at the start of a step."""
    case = fsiCase.Case(
        os.path.join(folder, "collision"), cells=(40, 40), cyclic="xy",
        viscosity=0.01, time_scheme="backward",
        shapes="disc { shape { type circle; radius 0.15; } "
               "material { density 1000; E 1e5; } }",
        placements="all { type listed; shape disc; objects "
                   "({ centre (0.25 0.5 0); velocity (1 0 0); } "
                   "{ centre (0.75 0.5 0); velocity (-1 0 0); }); }",
        properties="coupling { type none; } output { objectsEvery 1; }",
        deltaT=0.01, endTime=0.3, writeInterval=30)
    case.set_up()
    case.run("fsiPisoFoam")
    rows = results.table(case.path, "objects.csv")
    speeds = [abs(row["velocityX"]) for row in rows]
    print(f"    discs that met at 1 m/s part at {speeds[-1]:.3f} m/s")
    report.check("discs meet and part", min(speeds) < 0.5 < speeds[-1],
                 f"{speeds}")
    report.check("no gap closes", min(r["smallestGap"] for r in rows) > 0)
    report.check("they never get faster", max(speeds) < 1 + 1e-6,
                 f"{max(speeds)}")
    report.check("momentum is kept",
                 abs(sum(r["velocityX"] for r in rows[-2:])) < 1e-10)


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
    report.attempt("bodies", check_bodies, report, folder)
    report.attempt("restart of a disc", check_disc_restart, report, folder)
    report.attempt("collision", check_collision, report, folder)
    report.attempt("refusals", check_refusals, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
