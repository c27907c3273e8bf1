#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads of objects that depend on where they are, and a driving force that
depends on the time.

    loads.py FOLDER

1. A heavy disc, soft disc, membrane and sphere hang from traps: at rest the
   pull is the weight less the buoyancy. On three ranks as on one.
2. A disc follows a trap that moves.
3. A stream between two walls under an acceleration that swings: size and phase
   of the mean velocity against the exact solution.
"""

import cmath
import math
import os
import sys

import fsiCase
import results

MATERIALS = {
    "rigid": "type rigid; density 3;",
    "soft": "type neoHookean; density 3; E 500;",
    "sheet": "type membrane; density 1.2; law neoHookean; shearModulus 1;",
}

HANG = ("motion {{ type free; loads {{ trap {{ type trap; stiffness {}; "
        "place {}; }} }} }}")

STIFFNESS = 2


def hanging(folder, name, solid, steps=400):
    """Objects in a closed box, each in the trap of its shape."""
    places = {"rigid": 0.25, "soft": 0.75, "sheet": 1.25}
    size = 0.16 if solid else 1/24
    shapes = "".join(
        f"{shape} {{ shape {{ type {'sphere' if solid else 'circle'}; radius "
        f"0.12; }} material {{ {material} }} "
        + HANG.format(STIFFNESS*size, f"({places[shape]} 0.5 0.25)") + " }\n"
        for shape, material in MATERIALS.items())
    return fsiCase.Case(
        os.path.join(folder, name),
        box=(0, 0, 0, 1.5, 1, 0.5) if solid else (0, 0, 1.5, 1),
        cells=(36, 24, 12) if solid else (36, 24), viscosity=0.05,
        gravity="(0 -1 0)", shapes=shapes,
        placements="".join(
            f"{shape} {{ type listed; shape {shape}; objects "
            f"({{ centre ({x} 0.5 {0.25*solid}); }}); }}\n"
            for shape, x in places.items()),
        deltaT=0.02, endTime=0.02*steps, writeInterval=steps,
        writePrecision=17).set_up()


def check_hanging(report, folder):
    """Check 1."""
    case = hanging(folder, "plane", False)
    case.run("fsiPisoFoam")
    for row in results.table(case.path, "objects.csv")[-3:]:
        density = 1.2 if row["shape"] == "sheet" else 3
        weight = (density - 1)*row["area"]/24
        pull = STIFFNESS/24*(0.5 - row["centroidY"])
        print(f"    {row['shape']}: pull over weight {pull/weight:.4f}")
        report.check(f"a trap carries the weight of {row['shape']}",
                     abs(pull/weight - 1) < 0.01, f"{pull}, {weight}")
    for solid in (False, True):
        name = "solid" if solid else "plane"
        one = hanging(folder, name + "One", solid, 10)
        one.run("fsiPisoFoam")
        three = hanging(folder, name + "Three", solid, 10)
        three.run("fsiPisoFoam", ranks=three.decompose(3, 1))
        apart = results.difference(one.path, three.path, ("", "processor0"))
        report.check(f"{name}: three ranks", apart < 1e-6, f"{apart}")


def check_follows(report, folder):
    """Check 2."""
    case = fsiCase.Case(
        os.path.join(folder, "follows"), cells=(24, 24), viscosity=0.05,
        shapes="disc { shape { type circle; radius 0.15; } material "
               "{ type rigid; density 1; } " + HANG.format(
                   1, "table ((0 (0.3 0.5 0)) (2 (0.7 0.5 0)))") + " }",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.3 0.5 0); }); }",
        deltaT=0.02, endTime=4, writeInterval=200).set_up()
    case.run("fsiPisoFoam")
    row = results.table(case.path, "objects.csv")[-1]
    report.check("a disc follows its trap",
                 abs(row["centroidX"] - 0.7) < 0.01
                 and abs(row["centroidY"] - 0.5) < 1e-6, f"{row['centroidX']}")


def check_swinging(report, folder):
    """Check 3: in a channel of the width 1 the mean velocity is the real part
    of G e^(i w t)/(i w) (1 - tanh(k/2)/(k/2)), k^2 = i w/nu. The sheet is
    carried along."""
    nu, size, steps = 0.1, 0.1, 400
    omega = 2*math.pi
    k = cmath.sqrt(1j*omega/nu)
    # The sine is the real part of -i e^(i w t)
    exact = -size/omega*(1 - cmath.tanh(k/2)/(k/2))
    case = fsiCase.Case(
        os.path.join(folder, "swinging"), box=(0, 0, 0.5, 1), cells=(20, 40),
        viscosity=nu, cyclic="x",
        shapes="drop { shape { type circle; radius 0.1; } material { type "
               "membrane; density 1; law neoHookean; shearModulus 1e-6; } }",
        placements="a { type listed; shape drop; objects "
                   "({ centre (0.25 0.5 0); }); }",
        properties="drivingForce { type acceleration; acceleration { type "
                   f"sine; frequency 1; amplitude 1; scale ({size} 0 0); "
                   "level (0 0 0); } }",
        deltaT=1/steps, endTime=8, writeInterval=8*steps).set_up()
    case.run("fsiPisoFoam")
    rows = results.table(case.path, "global.csv")[-steps:]
    wave = 2/steps*sum(r["fluidVelocityX"]*cmath.exp(-1j*omega*r["time"])
                       for r in rows)
    print(f"    a stream that swings: size {abs(wave/exact):.4f} of the exact "
          f"one, phase {cmath.phase(wave/exact):.4f} rad")
    report.check("a swinging acceleration", abs(wave/exact - 1) < 0.02,
                 f"{wave} for {exact}")


def main(folder):
    """All checks."""
    report = fsiCase.Report()
    check_hanging(report, folder)
    report.attempt("a trap that moves", check_follows, report, folder)
    report.attempt("a swinging stream", check_swinging, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
