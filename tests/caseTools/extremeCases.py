# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of extremes.py: CASES has, by name, the parameters of fsiCase and
the words of the error that is expected, none where the case must be sound.
The lid of a box of 1 m moves at 1 m/s over a fluid of 1 kg/m3, so that E is in
units of rho U^2, unless a case says otherwise."""

import math

LID = {"walls": {"top": "(1 0 0)"}}
STREAM = {"left": ("type fixedValue; value uniform (1 0 0);",
                   "type zeroGradient;"),
          "right": ("type zeroGradient;", "type fixedValue; value uniform 0;")}
CUBE = {"box": (0, 0, 0, 1, 1, 1), "cells": (16, 16, 16), "deltaT": 0.02}


def ring(n, radius, turn, thickness):
    """Outline of a part of a ring, open to the right: a fold."""
    angles = [math.pi + turn*(i/(n - 1) - 0.5) for i in range(n)]
    outer = [(radius*math.cos(a), radius*math.sin(a)) for a in angles]
    inner = [((radius - thickness)*math.cos(a), (radius - thickness)
              * math.sin(a)) for a in reversed(angles)]
    return outer + inner


OUTLINES = {
    "plate.csv": [(0, 0), (0.6, 0), (0.6, 0.08), (0, 0.08)],
    "fold.csv": ring(40, 0.25, 1.7*math.pi, 0.09),
    "hook.csv": [(0, 0), (0.5, 0), (0.5, 0.45), (0.2, 0.45), (0.2, 0.3),
                 (0.4, 0.3), (0.4, 0.1), (0, 0.1)],
    "comb.csv": [(0, 0), (0.6, 0), (0.6, 0.4), (0.5, 0.4), (0.5, 0.1),
                 (0.35, 0.1), (0.35, 0.4), (0.25, 0.4), (0.25, 0.1),
                 (0.1, 0.1), (0.1, 0.4), (0, 0.4)],
    "wall.csv": [(-0.3, -0.7), (0.2, -0.7), (0.2, 0.7), (-0.3, 0.7)],
    "half.csv": [(-0.3, -0.7), (0.2, -0.7), (0.2, 0), (-0.3, 0)],
}


def body(shape, material, more=""):
    """The shape a."""
    return f"a {{ shape {{ {shape} }} material {{ {material} }} {more} }}"


def at(*places):
    """Objects of the shape a at places."""
    objects = " ".join(f"{{ centre ({' '.join(map(str, p))}); }}"
                       for p in places)
    return f"a {{ type listed; shape a; minimumGap 0; objects ({objects}); }}"


DISC, BALL = "type circle; radius 0.15;", "type sphere; radius 0.22;"
MIDDLE, CENTRE = at((0.5, 0.5, 0)), at((0.5, 0.5, 0.5))


def lid(shape, material, places=MIDDLE, **more):
    """An object below a moving lid."""
    return {**LID, "shapes": body(shape, material), "placements": places,
            **more}


def dense(fraction, key="areaFraction", gap=0.01):
    """As many as fit."""
    return (f"a {{ type packed; shape a; {key} {fraction}; sweeps 200; "
            f"minimumGap {gap}; }}")


SQUARE_FILL = {**LID, "placements": dense(0.6), "cells": (64, 64),
               "deltaT": 0.005, "adjustTimeStep": "yes", "maxDeltaT": 0.005}

CASES = {}


def add(name, values, *expected):
    """A case."""
    CASES[name] = (values, expected)


# Dense: 60 % of the box
for kind, material in (("elastic, E 10", "density 1; E 10;"),
                       ("elastic, E 1e5", "density 1; E 1e5;"),
                       ("neo-Hookean, E 10",
                        "density 1; E 10; type neoHookean;"),
                       ("rigid", "density 2; type rigid;"),
                       ("light, 0.1", "density 0.1; E 100;")):
    add(f"60 % of discs, {kind}",
        {**SQUARE_FILL,
         "shapes": body("type circle; radius 0.06;", material)})
add("60 % of ellipses, E 10",
    {**SQUARE_FILL, "placements": dense(0.6, gap=0.008), "shapes": body(
        "type ellipse; semiAxes (0.12 0.06);", "density 1; E 10;")})
add("40 % of spheres, E 100",
    {**LID, **CUBE, "cells": (20, 20, 20), "placements":
     dense(0.4, "volumeFraction", 0.004), "endTime": 1,
     "shapes": body("type sphere; radius 0.08;", "density 1; E 100;")})
add("40 % of rigid spheres",
    {**LID, **CUBE, "cells": (20, 20, 20), "placements":
     dense(0.4, "volumeFraction", 0.004), "endTime": 1,
     "shapes": body("type sphere; radius 0.08;", "density 2; type rigid;")})
add("95 % of discs", {**SQUARE_FILL, "placements": dense(0.95), "shapes": body(
    "type circle; radius 0.06;", "density 1; E 10;")}, "areaFraction")

# Density ratio
for density in (0.05, 0.1, 0.3, 10, 100, 1000):
    add(f"density ratio {density}, E 100",
        lid(DISC, f"density {density}; E 100;"))
    add(f"density ratio {density}, rigid",
        lid(DISC, f"density {density}; type rigid;"))
for density in (0.05, 0.3, 1000):
    add(f"sphere, density ratio {density}, E 100",
        lid(BALL, f"density {density}; E 100;", CENTRE, **CUBE))
    add(f"sphere, density ratio {density}, rigid",
        lid(BALL, f"density {density}; type rigid;", CENTRE, **CUBE))
for density in (0.05, 1000):
    add(f"density ratio {density}, gravity, E 100",
        {"shapes": body(DISC, f"density {density}; E 100;"), "speed": 3,
         "placements": MIDDLE, "gravity": "(0 -1 0)", "adjustTimeStep": "yes",
         "maxDeltaT": 0.01})

# Stiffness. The softest are drawn out without end, as they have no viscosity;
# in a fluid of little viscosity their own eddies fold them
SOFT = {"adjustTimeStep": "yes", "maxDeltaT": 0.01, "endTime": 5}
for modulus in (0.001, 0.01, 0.1, 1, 1e3, 1e6, 1e9):
    add(f"E = {modulus:g} rho U^2, springs",
        lid(DISC, f"density 1; E {modulus};", **SOFT))
add("E = 0.001 rho U^2, springs, Re 1000",
    lid(DISC, "density 1; E 0.001;", viscosity=1e-3, **SOFT),
    "cut themselves")
for modulus, words in ((0.001, ["cut themselves"]), (0.1, []), (1e9, [])):
    add(f"E = {modulus:g} rho U^2, neo-Hookean",
        lid(DISC, f"density 1; E {modulus}; type neoHookean;", **SOFT), *words)
for modulus in (0.01, 1e8):
    add(f"sphere, E = {modulus:g} rho U^2",
        lid(BALL, f"density 1; E {modulus};", CENTRE, **CUBE))
add("membrane, 0.001 of the usual stiffness",
    lid(DISC, "type membrane; density 1; shearModulus 0.0025; "
        "bendingModulus 1e-5; innerViscosity 0.01;"))

# Thin
add("ellipse of ratio 5.3, 4.8 cells thick",
    lid("type ellipse; semiAxes (0.32 0.06);", "density 1; E 10;"))
add("ellipse of ratio 16, 1.6 cells thick",
    lid("type ellipse; semiAxes (0.32 0.02);", "density 1; E 10;"),
    "minimumCells", "thick")
add("plate of ratio 7.5, E 10", lid('type polygon; file "plate.csv";',
                                    "density 1; E 10;"))
add("plate of ratio 7.5, rigid", lid('type polygon; file "plate.csv";',
                                     "density 2; type rigid;"))
add("disc of ratio 3 in three dimensions",
    lid("type ellipsoid; semiAxes (0.3 0.1 0.3);", "density 1; E 100;",
        CENTRE, **CUBE))

# Folded
for name in ("fold", "hook", "comb"):
    for modulus in (1, 100):
        add(f"{name}, E {modulus}",
            lid(f'type polygon; file "{name}.csv";',
                f"density 1; E {modulus};", adjustTimeStep="yes",
                maxDeltaT=0.01))

# Inlets
FIXED = "motion { type fixed; }"
add("inlet blocked by a fixed wall",
    {"open": STREAM, "placements": at((0.15, 0.5, 0)), "shapes": body(
        'type polygon; file "wall.csv";', "density 1; type rigid;", FIXED)},
    "block", "left")
add("lower half of the inlet blocked",
    {"open": STREAM, "placements": at((0.15, 0.15, 0)), "speed": 3,
     "shapes": body('type polygon; file "half.csv";',
                    "density 1; type rigid;", FIXED)})
add("channel blocked behind the inlet",
    {"open": STREAM, "placements": at((0.6, 0.5, 0)), "shapes": body(
        'type polygon; file "wall.csv";', "density 1; type rigid;", FIXED)},
    "left", "go nowhere")
add("free disc in front of a blocked inlet's half",
    {"open": STREAM, "speed": 3, "placements": at((0.2, 0.5, 0)),
     "shapes": body("type circle; radius 0.19;", "density 1; E 100;")})

# Steps
for steps, more in ((10, {}), (100, {}),
                    (100, {"adjustTimeStep": "yes", "maxDeltaT": 1})):
    add(f"step of {steps} times h/U{', adjusted' if more else ''}",
        lid(DISC, "density 1; E 100;", deltaT=0.025*steps/10,
            endTime=0.025*steps, **more))
add("step of 100 times h^2/nu", lid(DISC, "density 1; E 100;", viscosity=10,
                                     deltaT=0.00625, endTime=0.625))
add("discs a twentieth of a cell apart, E 1e6",
    lid(DISC, "density 1; E 1e6;", at((0.3, 0.5, 0), (0.60125, 0.5, 0)),
        adjustTimeStep="yes", maxDeltaT=0.01))
add("sphere, step of 10 times h/U",
    lid(BALL, "density 1; E 100;", CENTRE,
        **{**CUBE, "deltaT": 0.6, "endTime": 6}), "smaller deltaT")
