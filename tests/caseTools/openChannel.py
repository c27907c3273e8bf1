# SPDX-License-Identifier: GPL-3.0-or-later
"""A channel 2 long and 1 wide with discs, inflow on the left with speed 1."""

import os

import fsiCase

SPEED = 1

CELLS = (48, 24)

DISC = """
disc
{{
    shape {{ type circle; radius 0.15; }}
    material {{ density {}; E 100; }}
}}
"""

OPEN = {
    "left": (f"type fixedValue; value uniform ({SPEED} 0 0);",
             "type zeroGradient;"),
    "right": ("type zeroGradient;", "type fixedValue; value uniform 0;"),
}

# Walls that move with the fluid: nothing disturbs a uniform flow
PLUG = {"bottom": f"({SPEED} 0 0)", "top": f"({SPEED} 0 0)"}


def channel(folder, name, discs, density=1, **parameters):
    """The channel with discs (x, y, u) in it, seeded."""
    objects = " ".join(f"{{ centre ({x} {y} 0); velocity ({u} 0 0); }}"
                       for x, y, u in discs)
    options = {
        "box": (0, 0, 2, 1), "cells": CELLS, "open": OPEN,
        "velocity": f"({SPEED} 0 0)", "viscosity": 0.01,
        "shapes": DISC.format(density),
        "placements": "discs { type listed; shape disc; "
                      f"objects ({objects}); }}",
        "deltaT": 0.01, "endTime": 0.8, "writePrecision": 12,
        "p_tolerance": 1e-11, "U_tolerance": 1e-11, **parameters,
    }
    return fsiCase.Case(os.path.join(folder, name), **options).set_up()
