#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light elastic bodies in a cyclic box.

One that was pushed comes to rest: without a driving force its kinetic and
elastic energy can only fall. One that a driving acceleration or gravity sets
into motion has the acceleration of potential flow after the first step, and a
driving force that wants a mean velocity from rest gets it without an overshoot.

    lightBodies.py FOLDER

A disc of 6 mesh cells at moderate stiffness, where the last pressure deforms it
as much as its inertia resists (doc/theory.md, (5.19)). After the first step its
speed is that of potential flow, m/(m + m_a) of the one that it was pushed to,
with the added mass m_a of the fluid; at the end it is P/(8 pi mu t), P being
the push. In the second half of 100 steps less than half of the largest energy
is left.
"""

import math
import os
import re
import sys

import fsiCase
import results

STEP, STEPS = 0.01, 100
LEFT = 0.5

# Cells of its box to a side, and the largest error of the speed of one that was
# pushed, in a box of ten radii
CELLS, PUSHED = 30, 0.1

# A disc of the density LIGHT, of which 64 cells hold 12.8
RADIUS, LIGHT = 0.1, 0.1

# Largest error of its acceleration, and the steps
NEAR, START_STEPS = 0.05, (1e-2, 1e-3, 1e-4)

# Name, material, further entries of the shape, viscosity of the fluid
BODIES = (
    ("a fifth of the density", "density 0.2; E 10;", "", 0.002),
    ("a tenth", "density 0.1; E 10;", "", 0.002),
    ("neo-Hookean", "type neoHookean; density 0.3; E 10;", "", 0.0005),
    ("ADMM", "density 0.5; E 10;", "admm { scheme ADMM; }", 0.002),
    ("stiff", "density 0.1; E 1e4;", "", 0.002),
    ("soft", "density 0.1; E 0.5;", "", 0.002),
)


def energies(folder, material, entries, viscosity):
    """Kinetic and elastic energy after each step."""
    case = fsiCase.Case(
        os.path.join(folder, "case"), cells=(CELLS,)*2, viscosity=viscosity,
        cyclic="xy",
        shapes="disc { shape { type circle; radius 0.1; } "
               f"material {{ {material} }} {entries} }}",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.5 0.5 0); velocity (0.3 0.1 0); }); }",
        deltaT=STEP, endTime=STEPS*STEP, writeInterval=STEPS).set_up()
    case.run("fsiPisoFoam")
    return [row["kineticEnergy"] + row["elasticEnergy"]
            for row in results.table(case.path, "global.csv")]


def lattice_acceleration(density):
    """Of discs in a square lattice of period 1 in potential flow, over the
    acceleration that drives it: Maxwell's formula for the mobility 1/density
    (doc/theory.md, (7.3))."""
    part = math.pi*RADIUS**2
    contrast = (1 - density)/(1 + density)
    mean = (1 + part*contrast)/(1 - part*contrast)
    return (mean - 1)/(part*(1 - density))


def started(folder, discs, step, steps, material="E 1e6;", **parameters):
    """The case of light discs at rest at the centres given, solved."""
    case = fsiCase.Case(
        os.path.join(folder, "case"), cells=(64, 64), viscosity=1e-4,
        cyclic="xy",
        shapes=f"disc {{ shape {{ type circle; radius {RADIUS}; }} "
               f"material {{ density {LIGHT}; {material} }} }}",
        placements="a { type listed; shape disc; objects ("
                   + " ".join(f"{{ centre ({x} {y} 0); }}" for x, y in discs)
                   + "); }",
        deltaT=step, endTime=steps*step, writeInterval=steps,
        **parameters).set_up()
    case.run("fsiPisoFoam")
    return case


def first_velocity(folder, step, axis, **parameters):
    """Velocity of one disc after the first step, over the step's size."""
    case = started(folder, ((0.5, 0.5),), step, 1, **parameters)
    return results.table(case.path, "objects.csv")[-1]["velocity" + axis]/step


def check_start(report, folder):
    """Acceleration from rest by a driving force and by weight."""
    driven = lattice_acceleration(LIGHT)
    for step in START_STEPS:
        for name, exact, axis, parameters in (
                ("driven", driven, "X",
                 {"properties": "drivingForce { type acceleration; "
                                "acceleration (1 0 0); }"}),
                ("rises", driven - 1, "Y", {"gravity": "(0 -1 0)"}),
                ("rigid, rises", driven - 1, "Y",
                 {"gravity": "(0 -1 0)", "material": "type rigid;"})):
            name = f"{name}, step {step}"
            found = report.attempt(name, first_velocity, folder, step, axis,
                                   **parameters)
            if found is not None:
                print(f"    {name}: {found:.4g}, exact {exact:.4g}")
                report.check(f"{name}: first step",
                             abs(found/exact - 1) < NEAR,
                             f"{found}, not {exact}")


def check_mean_velocity(report, folder):
    """A driving force that wants the mean velocity 1 from rest, discs of a
    tenth of the density on 19 % of the area."""
    discs = [(x, y) for x in (0.18, 0.5, 0.82) for y in (0.27, 0.73)]
    case = report.attempt(
        "mean velocity", started, folder, discs, 0.005, 40,
        properties="drivingForce { type meanVelocity; velocity (1 0 0); }"
                   " output { log full; }")
    if case is None:
        return
    found = [float(m) for m in re.findall(
        r"Mean velocity (\S+),", results.read(case.path, "log.fsiPisoFoam"))]
    speeds = [row["maxSpeed"]
              for row in results.table(case.path, "global.csv")]
    print(f"    mean velocity: {min(found[5:]):.4g} to {max(found):.4g}, "
          f"largest speed {max(speeds):.4g}")
    report.check("mean velocity: no overshoot", max(found) < 1 + NEAR,
                 f"{max(found)}")
    report.check("mean velocity: reached", min(found[5:]) > 1 - NEAR,
                 f"{min(found[5:])}")
    report.check("mean velocity: speed", max(speeds) < 2*lattice_acceleration(
        LIGHT), f"{max(speeds)}")


def check_push(report, found):
    """Speed of the stiff disc of a tenth of the density after the first step
    and at the end, from its energy, over that in an unbounded fluid."""
    mass = LIGHT*math.pi*RADIUS**2
    push = mass*math.hypot(0.3, 0.1)
    exact = {
        "first step": push/(mass + math.pi*RADIUS**2),
        "end": push/(8*math.pi*0.002*STEPS*STEP),
    }
    for when, energy in (("first step", found[0]), ("end", found[-1])):
        speed = math.sqrt(2*energy/(mass/CELLS))
        print(f"    pushed, {when}: {speed/exact[when]:.3f} of the exact speed")
        report.check(f"pushed, {when}: speed",
                     abs(speed/exact[when] - 1) < PUSHED, f"{speed}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_start(report, folder)
    check_mean_velocity(report, folder)
    for name, *body in BODIES:
        found = report.attempt(name, energies, folder, *body)
        if found is None:
            continue
        if name == "stiff":
            check_push(report, found)
        report.check(f"{name}: all steps", len(found) == STEPS,
                     f"{len(found)} steps")
        half, largest = max(found[STEPS//2:]), max(found)
        print(f"    {name}: {half/largest:.3g} of the largest energy")
        report.check(f"{name}: comes to rest", 0 < half < LEFT*largest,
                     f"{half} of {largest} in the second half")


if __name__ == "__main__":
    main(sys.argv[1])
