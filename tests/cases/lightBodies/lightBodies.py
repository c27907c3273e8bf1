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
with the added mass m_a of the fluid; then it is that of a disc in an unbounded
Stokes flow. In the second half of 100 steps less than half of the largest
energy is left.

A disc and a sphere that start in a fluid at rest bring the momentum of their
own mass: in a periodic box, after some time, all moves with that momentum over
the mass.
"""

import cmath
import math
import os
import re
import sys

import fsiCase
import results

STEP, STEPS = 0.01, 100
LEFT = 0.5

# Cells of its box to a side, and the largest error of the speed of one that was
# pushed, in a box of ten radii: after the first step, and later, when it is
# slowed down by a layer thinner than a cell, one of the six cells
CELLS, PUSHED, SLOWED = 30, 0.1, 1/6

# Largest error of the momentum of a body that starts in a fluid at rest, over
# density of the fluid, volume and speed
MOMENTUM = 0.02

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


def bessel(order, z):
    """The modified Bessel function K."""
    last = math.acosh(1 + 40/z.real)
    step = last/400
    return step*(cmath.exp(-z)/2 + sum(
        cmath.exp(-z*math.cosh(i*step))*math.cosh(order*i*step)
        for i in range(1, 401)))


def slowed(time):
    """Speed of a light disc in Stokes flow, over that of potential flow after
    the push; time in R^2/nu. The force on a disc with the Laplace transform V
    of its velocity is -pi rho R^2 s V (1 + 4 K1(z)/(z K0(z))), with z = R
    sqrt(s/nu). The inverse is Talbot's, with the contour of Weideman."""
    n = 24
    total = 0
    for k in range(n):
        a = -math.pi + (2*k + 1)*math.pi/n
        b = 0.6407*a
        z = n*(0.5017*a/math.tan(b) - 0.6122 + 0.2645j*a)
        dz = n*(0.5017/math.tan(b) - 0.5017*b/math.sin(b)**2 + 0.2645j)
        root = cmath.sqrt(z/time)
        added = 1 + 4*bessel(1, root)/(root*bessel(0, root))
        total += cmath.exp(z)*dz*(LIGHT + 1)/(z*(LIGHT + added))
    return (total/(1j*n)).real


def check_push(report, found):
    """Speed of the stiff disc of a tenth of the density after the first step
    and later, from its energy, over that in an unbounded fluid."""
    mass = LIGHT*math.pi*RADIUS**2
    first = math.hypot(0.3, 0.1)*LIGHT/(1 + LIGHT)
    for step in (1, 5, 10, 20, 50, STEPS):
        speed = math.sqrt(2*found[step - 1]/(mass/CELLS))
        exact = first
        if step > 1:
            exact *= slowed(0.002*step*STEP/RADIUS**2)
        print(f"    pushed, step {step}: {speed/exact:.3f} of the exact speed")
        report.check(f"pushed, step {step}: speed",
                     abs(speed/exact - 1) < (SLOWED if step > 1 else PUSHED),
                     f"{speed}, not {exact}")


def momentum(folder, shape, volume, box, cells):
    """Momentum that a body of the fluid's density has brought into a periodic
    box of three diameters, less its own, over density, volume and speed."""
    case = fsiCase.Case(
        os.path.join(folder, "case"), box=box, cells=cells, viscosity=1,
        cyclic="xyz"[:len(cells)],
        shapes=f"body {{ shape {{ {shape} }} material {{ density 1; "
               "type rigid; } }",
        placements="a { type listed; shape body; objects "
                   f"({{ centre (0.51 0.5 {0.49*(len(cells) - 2)}); "
                   "velocity (1 0 0); }); }",
        deltaT=1/cells[0]**2, endTime=40/cells[0]**2,
        writeInterval=40).set_up()
    case.run("fsiPisoFoam")
    flow = results.field(case.path, results.times(case.path)[-1], "U")[::3]
    return sum(flow)/len(flow)/volume - 1


def check_momentum(report, folder):
    """Bodies of six and twelve cells that start in a fluid at rest."""
    for name, *case in (
            ("disc, 6 cells", "type circle; radius 0.166667;", math.pi/36,
             (0, 0, 1, 1), (18, 18)),
            ("disc, 12 cells", "type circle; radius 0.166667;", math.pi/36,
             (0, 0, 1, 1), (36, 36)),
            ("sphere, 6 cells", "type sphere; radius 0.166667;",
             4*math.pi/3/6**3, (0, 0, 0, 1, 1, 1), (18, 18, 18))):
        found = report.attempt(name, momentum, folder, *case)
        if found is not None:
            print(f"    {name}: {found:.4f} rho V v too much")
            report.check(f"{name}: momentum", abs(found) < MOMENTUM,
                         f"{found} rho V v too much")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_start(report, folder)
    check_mean_velocity(report, folder)
    check_momentum(report, folder)
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
