# SPDX-License-Identifier: GPL-3.0-or-later
"""Small cases for any number of ranks, in two and in three dimensions: elastic,
membrane, rigid and fixed objects, a feed, walls, and a periodic direction.
Every collective call is checked (DebugSwitches collectiveCalls)."""

import os

import fsiCase
import results

# Of an object's size
TOLERANCE = 1e-8

CONTROLS = {"startFrom": "latestTime", "writePrecision": 17,
            "DebugSwitches": "{ collectiveCalls 1; }",
            "p_tolerance": 1e-12, "U_tolerance": 1e-12}

OPEN = {"left": ("type fixedValue; value uniform (1 0 0);",
                 "type zeroGradient;"),
        "right": ("type zeroGradient;", "type fixedValue; value uniform 0;")}

PLANE_SHAPES = """
disc { shape { type circle; radius 0.12; } material { density 1.1; E 100; } }
cell { shape { type circle; radius 0.12; }
    material { type membrane; density 1; shearModulus 0.25;
        bendingModulus 1e-4; innerViscosity 0.1; } }
ball { shape { type circle; radius 0.11; }
    material { density 1.2; type rigid; } }
post { shape { type circle; radius 0.1; }
    material { density 1; type rigid; } motion { type fixed; } }
"""

# The disc lies on the cut of two ranks in x, the ball on one of three
PLANE_PLACEMENTS = """
discs { type listed; shape disc; objects ({ centre (1 0.5 0); }); }
cells { type listed; shape cell; objects ({ centre (0.68 0.3 0); }); }
balls { type listed; shape ball; objects ({ centre (1.34 0.33 0); }); }
posts { type listed; shape post; objects ({ centre (1.4 0.72 0); }); }
"""

FEED = """
boundaries { feed { left { shape disc; rate 50; velocity (1 0 0);
    sideGap 0.05; minimumGap 0.1; startTime 0.005; } } }
"""


def channel(path, **parameters):
    """A channel in two dimensions, 2 x 1, that is fed with discs."""
    return fsiCase.Case(path, **{
        "box": (0, 0, 2, 1), "cells": (48, 24), "open": OPEN,
        "velocity": "(1 0 0)", "shapes": PLANE_SHAPES,
        "placements": PLANE_PLACEMENTS, "properties": FEED,
        "deltaT": 0.005, "endTime": 0.04, "writeInterval": 4,
        **CONTROLS, **parameters}).set_up()


def box(path, **parameters):
    """A box in three dimensions, periodic in x, with a moving wall and spheres,
    one of them on the seam."""
    shapes = """
sphere { shape { type sphere; radius 0.2; } material { density 1.1; E 100; } }
ball { shape { type sphere; radius 0.18; }
    material { density 1.2; type rigid; } }
"""
    placements = """
a { type listed; shape sphere; objects ({ centre (0.02 0.5 0.5); }); }
b { type listed; shape ball; objects ({ centre (0.55 0.4 0.52); }); }
"""
    return fsiCase.Case(path, **{
        "box": (0, 0, 0, 1, 1, 1), "cells": (16, 16, 16), "cyclic": "x",
        "walls": {"top": "(1 0 0)"}, "shapes": shapes,
        "placements": placements, "deltaT": 0.01, "endTime": 0.06,
        "writeInterval": 3, **CONTROLS, **parameters}).set_up()


def odd(path, **parameters):
    """A square that is periodic in both directions, with an odd number of
    cells, and a stream past a post."""
    return fsiCase.Case(path, **{
        "cells": (45, 45), "cyclic": "xy", "velocity": "(1 0.7 0)",
        "shapes": PLANE_SHAPES, "placements":
        "a { type listed; shape post; objects ({ centre (0.5 0.6 0); }); }\n"
        "b { type listed; shape ball; objects ({ centre (0.6 0.97 0); }); }\n",
        "deltaT": 0.004, "endTime": 0.04, "writeInterval": 10, **CONTROLS,
        **parameters}).set_up()


CROWD_SHAPES = """
disc { shape { type circle; radius 0.09; } material { density 1.1; E 100; } }
cell { shape { type circle; radius 0.08; }
    material { type membrane; density 1; shearModulus 0.25;
        bendingModulus 1e-4; innerViscosity 0.1; } }
ball { shape { type circle; radius 0.07; }
    material { density 1.2; type rigid; } }
"""


def crowd(path, **parameters):
    """A channel that is periodic in x, 2 x 1, full of discs, membranes and
    balls that touch and cross the seam and all cuts; discs and balls move every
    way at the start."""
    shapes = ("disc", "cell", "ball")
    objects = {shape: [] for shape in shapes}
    for i in range(8):
        for j in range(4):
            shape = shapes[(4*i + j) % 3]
            speed = 0 if shape == "cell" else (-1)**i
            objects[shape].append(
                f"{{ centre ({0.13 + 0.25*i + 0.01*(j % 2)} "
                f"{0.13 + 0.245*j} 0); "
                f"velocity ({0.5*speed*(-1)**j} {0.3*speed} 0); }}")
    placements = "\n".join(
        f"{shape}s {{ type listed; shape {shape}; objects ({' '.join(of)}); }}"
        for shape, of in objects.items())
    return fsiCase.Case(path, **{
        "box": (0, 0, 2, 1), "cells": (96, 48), "cyclic": "x",
        "walls": {"top": "(1 0 0)"}, "viscosity": 0.01,
        "shapes": CROWD_SHAPES, "placements": placements, "deltaT": 0.002,
        "endTime": 0.1, "writeInterval": 25, **CONTROLS, **parameters}).set_up()


def dense(path, **parameters):
    """Rigid discs at 40 % in a shear that is periodic in x, with steps of
    10 h^2/nu: films begin and end within a step, and cells become fluid."""
    case = fsiCase.Case(path, **{
        "box": (-6, -6, 6, 6), "cells": (48, 48), "cyclic": "x",
        "viscosity": 10, "walls": {"top": "(6 0 0)", "bottom": "(-6 0 0)"},
        "shapes": "ball { shape { type circle; radius 1; } "
                  "material { density 1; type rigid; } }",
        "placements": "a { type packed; shape ball; areaFraction 0.4; "
                      "minimumGap 0.03; wallGap 0.03; }",
        "deltaT": 0.0625, "endTime": 0.5, "writeInterval": 8, **CONTROLS,
        **parameters})
    case.set_velocity(lambda x, y, z=0: (y, 0))
    return case.set_up()


def decompose(case, parts, options=()):
    """Cuts a case into nx by ny by nz ranks (parts), or into three of which the
    second has no cells ("hollow"); the number of ranks."""
    if parts != "hollow":
        return case.decompose(*parts, options=options)
    n = case.values["cells"]
    cells = 1
    for size in n:
        cells *= size
    ranks = "\n".join("0" if 2*(i % n[0]) < n[0] else "2"
                      for i in range(cells))
    case.file("constant/cellDecomposition", f"{cells}\n(\n{ranks}\n)\n",
              "labelList")
    case.file("system/decomposeParDict",
              "numberOfSubdomains 3; method manual; manualCoeffs "
              "{ dataFile \"cellDecomposition\"; }\n")
    case.run("decomposePar", *options)
    return 3


def same(report, name, serial, case):
    """The last objects, which the first rank wrote, are those of the serial
    run."""
    error = results.difference(serial.path, case.path, ("", "processor0"))
    report.check(f"{name}: the objects of one rank", error <= TOLERANCE,
                 f"{error:.2e} of an object's size")
    print(f"    {name}: {error:.2e} of an object's size")


def compare(report, folder, build, decompositions):
    """Runs a case on one rank and in each decomposition."""
    kind = build.__name__
    serial = build(os.path.join(folder, kind))
    serial.run("fsiPisoFoam")
    for parts in decompositions:
        name = f"{kind} {parts}"
        case = build(os.path.join(folder, name.replace(" ", "")))

        def run(case=case, parts=parts, name=name):
            n_ranks = decompose(case, parts)
            case.run("fsiPisoFoam", ranks=n_ranks)
            same(report, name, serial, case)

        report.attempt(name, run)
