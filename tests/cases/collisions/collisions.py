#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Collisions without a fluid, of two rigid bodies and of one with a wall.

    collisions.py FOLDER

They part with the fraction `restitution` of the speed at which they met, at any
step: a quarter, a sixteenth and four times of one in which a body moves by an
eighth of a cell (5 %). Where a body that deforms is beside them, it is the
same. In a gas that hardly resists they keep at least 0.85 of the speed; with a
roughness they lose what the film takes (5 %).

No collision makes energy, with `backward` neither: the sum of kinetic, elastic
and contact energy is never above that of the start by more than 0.1 %. Rigid
ellipsoids that turn by 0.025 and 0.05 in a step hit the sides of a box again
and again.
"""

import math
import os
import sys

import fsiCase
import results

N, RADIUS = 28, 0.12

# Of discs in a gas
ROUGHNESS = 2e-7

# Way of a body in a step in cells; the first is four times the second
COURANTS = (0.5, 0.125, 0.125/4, 0.125/16)


def meet(folder, name, **parameters):
    """Runs a case; its rows and the largest energy over that of the start."""
    values = {"properties": "coupling { type none; } "
              "output { objectsEvery 1; }", **parameters}
    case = fsiCase.Case(os.path.join(folder, name), **values).set_up()
    case.run("fsiPisoFoam")
    energies = [sum(row[key + "Energy"] for key in
                    ("kinetic", "elastic", "contact"))
                for row in results.table(case.path, "global.csv")]
    return (results.table(case.path, "objects.csv"),
            max(energies)/energies[0])


def parts(folder, dims, other, e, courant, scheme="Euler", beside=""):
    """Fraction of the speed left, and the largest energy. beside: centre of a
    body that deforms."""
    form = "circle" if dims == 2 else "sphere"
    middle = "0.5 0" if dims == 2 else "0.5 0.5"
    objects = ([f"{{ centre (0.3 {middle}); velocity (1 0 0); }}",
                f"{{ centre (0.7 {middle}); velocity (-1 0 0); }}"]
               if other == "pair" else
               [f"{{ centre (0.6 {middle}); velocity (1 0 0); }}"])
    box = {2: (0, 0, 1, 1), 3: (0, 0, 0, 1, 1, 1)}[dims]
    rows, energy = meet(
        folder, f"{dims}D-{other}-{e}-{courant}-{scheme}{beside and '-mixed'}",
        cells=(N,)*dims, box=box, time_scheme=scheme,
        shapes=f"body {{ shape {{ type {form}; radius {RADIUS}; }} "
               "material { type rigid; density 2; } }\n"
               + (f"soft {{ shape {{ type {form}; radius {RADIUS}; }} "
                  "material { type neoHookean; E 1e3; density 1; } }"
                  if beside else ""),
        placements="all { type listed; shape body; objects ("
                   + " ".join(objects) + "); }"
                   + ("soft { type listed; shape soft; objects ({ centre "
                      f"{beside}; }}); }}" if beside else ""),
        properties="coupling { type none; } output { objectsEvery 1; } "
                   f"contact {{ law {{ restitution {e}; }} }}",
        deltaT=courant/N, endTime=0.7)
    # The first moves to the left after it has met the other or the wall
    after = [row["velocityX"] for row in rows
             if row["object"] == 0 and row["velocityX"] < 0
             and row["contacts"] == 0]
    return (-after[0] if after else 0), energy


def check_restitution(report, folder):
    """The table of restitutions."""
    for dims in (2, 3):
        for other in ("wall", "pair"):
            for e in (1, 0.8, 0.5):
                # The smallest step of spheres takes minutes
                courants = COURANTS if dims == 2 else COURANTS[:3]
                left, energy = zip(*(
                    parts(folder, dims, other, e, c) for c in courants))
                print(f"    {dims}D, {other}, e = {e}: "
                      + ", ".join(f"{v:.3f}" for v in left))
                for courant, value in zip(courants, left):
                    report.check(
                        f"{dims}D, {other}, restitution {e}, {courant} cells "
                        "in a step", abs(value/e - 1) < 0.05, f"{value:.3f}")
                report.check(f"{dims}D, {other}, {e}: no energy is made",
                             max(energy) < 1.001, f"{energy}")


def check_mixed(report, folder):
    """Two rigid discs beside one that deforms."""
    for e in (1, 0.5):
        for courant in COURANTS[:2]:
            left, _ = parts(folder, 2, "pair", e, courant,
                            beside="(0.5 0.15 0)")
            report.check(f"beside a body that deforms, restitution {e}, "
                         f"{courant} cells in a step",
                         abs(left/e - 1) < 0.05, f"{left:.3f}")


def after_in_gas(folder, name, n, contact):
    """Speed of two rigid discs after they have met in a gas at 1."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(n, n), density=0.01,
        viscosity=1e-3, box=(0, 0, 1, 1), shapes="body { shape { type circle; "
        f"radius {RADIUS}; }} material {{ type rigid; density 2; }} }}",
        placements="all { type listed; shape body; objects ({ centre "
        "(0.3 0.5 0); velocity (1 0 0); } { centre (0.7 0.5 0); "
        "velocity (-1 0 0); }); }", properties="output { objectsEvery 1; } "
        f"contact {{ {contact} }}", deltaT=0.125/n, endTime=0.3).set_up()
    case.run("fsiPisoFoam")
    return -results.table(case.path, "objects.csv")[-2]["velocityX"]


def check_gas(report, folder):
    """Two rigid discs in a gas. The film between 0.1 cells and a roughness g
    takes 6 sqrt(2) pi mu (R/2)^(3/2) (1/sqrt(g) - 1/sqrt(0.1 h)) over half of a
    disc's mass from their speed, twice; half of that from the one of each."""
    left = after_in_gas(folder, "gas", N, "")
    report.check("two discs in a gas part", 0.85 < left < 1, f"{left:.4f}")

    rough = after_in_gas(folder, "rough", 3*N, f"roughness {ROUGHNESS};")
    film = (6*math.sqrt(2)*math.pi*1e-5*(RADIUS/2)**1.5
            * (ROUGHNESS**-0.5 - (0.1/(3*N))**-0.5)/(math.pi*RADIUS**2))
    print(f"    in a gas: {left:.3f}, and {rough:.3f} with a roughness, the "
          f"film has {film:.3f}")
    report.check("the film takes its impulse from two discs in a gas",
                 abs((left - rough)/film - 1) < 0.05, f"{rough:.4f}")


def check_backward(report, folder):
    """Energies with backward."""
    for other in ("wall", "pair"):
        left, energy = zip(*(parts(folder, 2, other, 1, c, "backward")
                             for c in (0.35,) + COURANTS[1:]))
        print(f"    backward, {other}: "
              + ", ".join(f"{v:.3f}" for v in left))
        report.check(f"backward, {other}: no energy is made",
                     max(energy) < 1.001, f"{energy}")
    for step in (0.005, 0.01):
        _, energy = meet(
            folder, f"box-{step}", cells=(14, 14, 14), box=(0, 0, 0, 1, 1, 1),
            time_scheme="backward",
            shapes="a { shape { type ellipsoid; semiAxes (.3 .2 .12); } "
                   "material { type rigid; density 2; } }",
            placements="all { type listed; shape a; objects ({ centre "
                       "(.5 .5 .5); velocity (1 .6 .3); angularVelocity "
                       "(.05 5 .05); }); }",
            deltaT=step, endTime=4)
        report.check(f"backward, an ellipsoid in a box, {step}",
                     energy < 1.001, f"{energy}")


def check_stopped(report, folder):
    """With backward a film stops two discs in one step, at gaps of 0.3, 0.6
    and 1 cells: the change of the velocity is no sign for the step after it."""
    h, radius = 1/32, 4/32
    for gap in (0.3, 0.6, 1):
        x = radius + gap*h/2
        case = fsiCase.Case(
            os.path.join(folder, f"stopped{gap}"), viscosity=1,
            box=(-0.5, -0.5, 0.5, 0.5), cyclic="xy", time_scheme="backward",
            shapes=f"d {{ shape {{ type circle; radius {radius}; }} "
                   "material { type rigid; density 1; } }",
            placements="a { type listed; shape d; objects "
                       f"({{ centre ({x} 0.003 0); velocity (-1 0 0); }} "
                       f"{{ centre ({-x} -0.003 0); velocity (1 0 0); }}); }}",
            deltaT=0.5*h, endTime=10*h, writeInterval=1).set_up()
        case.run("fsiPisoFoam")
        most = [max(abs(u) for u in results.field(case.path, t, "U"))
                for t in results.times(case.path)[1:]]
        report.check(f"backward, a film stops discs, gap {gap}",
                     max(most) < 1.01 and most[-1] < 0.01, f"{most}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("restitution", check_restitution, report, folder)
    report.attempt("mixed", check_mixed, report, folder)
    report.attempt("gas", check_gas, report, folder)
    report.attempt("backward", check_backward, report, folder)
    report.attempt("stopped", check_stopped, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
