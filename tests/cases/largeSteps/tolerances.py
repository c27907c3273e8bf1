# SPDX-License-Identifier: GPL-3.0-or-later
"""A tolerance of the pressure equation gives the same error of the velocity at
small and at large steps (doc/theory.md, (5.31))."""

import math
import os

import fsiCase
import results

TOLERANCE = 1e-4

# Steps over h^2/nu
STEPS = (1, 1e2, 1e4, 1e5)

# Largest error of the velocity over the tolerance: it may grow from step to
# step
MOST = 5

CASES = {
    "disc": {"cells": (32, 32), "walls": {"top": "(1 0 0)"},
             "shapes": "a { shape { type circle; radius 0.2; } "
                       "material { density 1; E 20; } }",
             "placements": "p { type listed; shape a; "
                           "objects ({ centre (.35 .35 0); }); }"},
    "capsule": {"cells": (16, 16, 16), "box": (0, 0, 0, 1, 1, 1),
                "walls": {"top": "(1 0 0)"},
                "shapes": "a { shape { type sphere; radius 0.25; } "
                          "material { type membrane; law neoHookean; "
                          "density 1; shearModulus %g; } }",
                "placements": "p { type listed; shape a; "
                              "objects ({ centre (.4 .4 .4); }); }"},
}


def velocity(folder, name, diffusion, tolerance):
    """Velocity after three steps of a case."""
    case = dict(CASES[name])
    n, step = case["cells"][0], 0.5/32
    viscosity = diffusion/n**2/step
    if name == "capsule":
        case["shapes"] = case["shapes"] % (0.3*viscosity)
    case = fsiCase.Case(
        os.path.join(folder, f"{name}-{diffusion:g}-{tolerance:g}"),
        viscosity=viscosity, p_tolerance=tolerance, U_tolerance=1e-12,
        properties="coupling { passes 1; }", deltaT=step, endTime=3*step,
        writeControl="timeStep", writeInterval=3, **case).set_up()
    case.run("fsiPisoFoam")
    return results.field(case.path, results.times(case.path)[-1], "U")


def error(folder, name, diffusion):
    """Difference to the velocity of a tolerance of 1e-12, over its size."""
    loose, tight = (velocity(folder, name, diffusion, tolerance)
                    for tolerance in (TOLERANCE, 1e-12))
    return math.dist(loose, tight)/math.hypot(*tight)


def check(report, folder):
    """All steps of both cases."""
    for name in CASES:
        errors = [error(folder, name, diffusion) for diffusion in STEPS]
        print(f"    {name}: errors over the tolerance "
              + ", ".join(f"{e/TOLERANCE:.2g}" for e in errors))
        report.check(f"the tolerance of p holds for the velocity of a {name}",
                     max(errors) < MOST*TOLERANCE, f"errors {errors}")
