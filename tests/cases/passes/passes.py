#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes of a time step, which large steps need (doc/theory.md, (5.21)).

    passes.py FOLDER

The disc of tutorials/validation/timeStep.py. With eight passes a step of
41 h^2/nu gives the mean velocity of steps an eighth as large within 1 %; with
one pass it gives a suspension that is too thin. The passes end where they
should, and say so in the log.

A force that sets the fluid around a fixed disc off within one step, to many
cells per step: all passes of the step find the same flow.

Films couple bodies that roll on each other: discs at 45 % in a shear flow have
the viscosity of small steps with steps of four h^2/nu, too. So have steps of
second order, which begin where bodies are expected, if those do not overlap.

A free disc that a flow presses against a fixed one resists the flow as if it
were fixed, too: contact holds it against the friction of the fluid. So it does
with an entered stiffness that is far too small to hold it.
"""

import os
import re
import sys

import fsiCase
import results

CELLS = 64
LARGE, SMALL = 0.01, 0.00125


def solve(folder, name, step, coupling=""):
    """Mean velocity in the mean from 0.8 to 1 s, and the passes of each
    step with the error of the last one."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(CELLS, CELLS), viscosity=1,
        cyclic="x", shapes="disc { shape { type circle; radius 0.25; } "
                           "material { density 1; E 1e4; } }",
        placements="all { type listed; shape disc; "
                   "objects ({ centre (0.5 0.35 0); }); }",
        properties="output { log full; } drivingForce { type acceleration; "
                   "acceleration (12 0 0); } contact { range 1; } "
                   f"coupling {{ type solidImplicit; {coupling} }}",
        writeControl="adjustableRunTime",
        deltaT=step, endTime=1, writeInterval=0.02).set_up()
    log = case.run("fsiPisoFoam")
    means = [sum(results.field(case.path, t, "U")[::3])/CELLS**2
             for t in results.times(case.path) if float(t) > 0.79]
    ends = (means[0] + means[-1])/2
    found = re.findall(r"Passes: (\d+), .*splitting error: ([-+.0-9e]+)", log)
    return ((sum(means) - ends)/(len(means) - 1),
            [(int(n), float(error)) for n, error in found])


def check_velocity(report, folder):
    """Against small steps."""
    small, _ = solve(folder, "small", SMALL, "passes 8;")
    large, _ = solve(folder, "large", LARGE, "passes 8;")
    one, passes = solve(folder, "one", LARGE, "passes 1;")
    report.check("large steps have the velocity of small ones",
                 abs(large/small - 1) < 0.01, f"{large}, not {small}")
    report.check("one pass does not",
                 one/small - 1 > 0.03 and {n for n, _ in passes} == {1},
                 f"{one}, {small}")


def check_end(report, folder):
    """Tolerance and number of passes."""
    for tolerance in (0.01, 0.001):
        _, steps = solve(folder, f"to{tolerance}", LARGE,
                         f"passes 40; passTolerance {tolerance};")
        report.check(f"passes come to {tolerance} and no further",
                     len(steps) == 100
                     and all(error <= tolerance for _, error in steps)
                     and any(error > tolerance/4 for _, error in steps)
                     and all(n < 40 for n, _ in steps), f"{steps}")
    _, steps = solve(folder, "three", LARGE, "passes 3; passTolerance 1e-9;")
    report.check("no more passes than wanted",
                 {n for n, _ in steps} == {3}, f"{steps}")


def check_sudden(report, folder):
    """In the first step a force gives the fluid this speed; a disc in a flow
    without friction has at most twice that beside it, here with less room."""
    step, speed, cells = 0.01, 10, 40
    case = fsiCase.Case(
        os.path.join(folder, "sudden"), cells=(cells, cells), viscosity=0.01,
        cyclic="x", deltaT=step, maxDeltaT=step, adjustTimeStep="yes",
        endTime=2*step,
        shapes="disc { shape { type circle; radius 0.2; } material { type "
               "rigid; density 1; } motion { type fixed; } }",
        placements="all { type listed; shape disc; "
                   "objects ({ centre (0.5 0.42 0); }); }",
        properties="drivingForce { type acceleration; "
                   f"acceleration ({speed/step} 0 0); }}").set_up()
    courant = re.findall(r"(?m)^Time = .* Co (\S+)", case.run("fsiPisoFoam"))
    most = 2.5*speed*step*cells
    report.check("a sudden flow is found in its first step",
                 0.25*most < float(courant[1]) < most,
                 f"Courant number {courant[1]}, not below {most}")


def pressed(folder, name, step, motion, law=""):
    """Mean velocity of a steady Stokes flow with a disc of this motion before
    a fixed one, at the gap of contact."""
    cells, radius = 32, 0.125
    # Passes leave a part of the start, which falls to 1 % in ten steps of
    # 41 h^2/nu and to 0.1 % in fifty
    end = max(0.4, 50*step)
    rigid = "material { type rigid; density 1; }"
    gap = 0.1/cells
    x = 0.5 - radius - gap/2
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(cells, cells), viscosity=1,
        cyclic="x", deltaT=step, endTime=end,
        writeControl="adjustableRunTime", writeInterval=end,
        shapes=f"disc {{ shape {{ type circle; radius {radius}; }} {rigid} "
               f"{motion} }} post {{ shape {{ type circle; radius {radius}; }} "
               f"{rigid} motion {{ type fixed; }} }}",
        placements="a { type listed; shape disc; objects "
                   f"({{ centre ({x} 0.5 0); }}); }} "
                   "b { type listed; shape post; objects "
                   f"({{ centre ({x + 2*radius + gap} 0.5 0); }}); }}",
        properties="drivingForce { type acceleration; "
                   "acceleration (1e-3 0 0); } contact { range 1; "
                   f"law {{ {law} }} }}").set_up()
    case.run("fsiPisoFoam")
    flow = results.field(case.path, results.times(case.path)[-1], "U")[::3]
    return sum(flow)/len(flow)


def check_contact(report, folder):
    """dt nu/h^2 of 1, where steps have one pass, 10 and 41."""
    for step in (0.001, 0.01, 0.04):
        fixed = pressed(folder, f"fixed{step}", step, "motion { type fixed; }")
        for name, law in (("free", ""), ("law", "stiffness 1e-9;")):
            free = pressed(folder, f"{name}{step}", step, "", law)
            report.check(f"contact holds a disc in a flow, step {step} {law}",
                         abs(free/fixed - 1) < 0.01,
                         f"mean velocity {free}, not {fixed}")


def dense(folder, name, step, coupling="", scheme="Euler", end=0.2):
    """Viscosity of discs at 45 %, of radius 1 and 4 cells, between walls."""
    half, viscosity = 6, 10
    case = fsiCase.Case(
        os.path.join(folder, name), box=(-half, -half, half, half),
        cells=(8*half, 8*half), cyclic="x", viscosity=viscosity,
        walls={"top": f"({half} 0 0)", "bottom": f"({-half} 0 0)"},
        shapes="disc { shape { type circle; radius 1; } "
               "material { type rigid; density 1; } }",
        placements="a { type packed; shape disc; areaFraction 0.45; "
                   "minimumGap 0.03; wallGap 0.03; }",
        properties="output { rheology yes; } contact { range 1; } "
                   f"coupling {{ type solidImplicit; {coupling} }}",
        time_scheme=scheme, deltaT=step/(16*viscosity), endTime=end,
        writeControl="adjustableRunTime", writeInterval=end)
    case.set_velocity(lambda x, y, z=0: (y, 0))
    case.set_up().run("fsiPisoFoam")
    values = [row["viscosity"] for row in
              results.table(case.path, "rheology.csv") if row["time"] > end/2]
    return sum(values)/len(values)


def check_dense(report, folder):
    """Against a step of a quarter of h^2/nu."""
    small = dense(folder, "denseSmall", 0.25)
    for scheme in ("Euler", "backward"):
        for step in (4, 1):
            large = dense(folder, f"dense{scheme}{step}", step, "", scheme)
            report.check(f"dense discs, {scheme}, step {step}",
                         abs(large/small - 1) < 0.01, f"{large}, not {small}")
    # The states part in 32 such steps, but no scheme may break
    euler, backward = (dense(folder, f"long{scheme}", 16, "", scheme, 3.2)
                       for scheme in ("Euler", "backward"))
    report.check("dense discs, backward, step 16",
                 abs(backward/euler - 1) < 0.1, f"{backward}, not {euler}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("velocity", check_velocity, report, folder)
    report.attempt("end of the passes", check_end, report, folder)
    report.attempt("sudden flow", check_sudden, report, folder)
    report.attempt("contact", check_contact, report, folder)
    report.attempt("dense", check_dense, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
