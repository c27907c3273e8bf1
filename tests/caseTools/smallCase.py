# SPDX-License-Identifier: GPL-3.0-or-later
"""A small case with a disc, a membrane and a post in a driven cavity, and
which of its files are those of a result."""

import os

import fsiCase

DISC_AND_CELL = """
disc
{
    shape { type circle; radius 0.15; }
    material { density 1.1; E 20; springLaw { type Maxwell; viscosity 1; } }
}
cell
{
    shape { type circle; radius 0.15; }
    material { type membrane; density 1; shearModulus 0.25;
        bendingModulus 1e-4; innerViscosity 0.1; }
}
"""

SHAPES = DISC_AND_CELL + """
post
{
    shape { type circle; radius 0.12; }
    material { type rigid; density 2; }
    motion { type fixed; }
}
"""

PLACEMENTS = """
discs { type listed; shape disc; objects ({ centre (0.3 0.75 0); }); }
cells { type listed; shape cell; objects ({ centre (0.7 0.7 0); }); }
posts { type listed; shape post; objects ({ centre (0.5 0.25 0); }); }
"""


def small_case(path, **parameters):
    """The case, seeded."""
    options = {"cells": (24, 24), "walls": {"top": "(1 0 0)"},
               "shapes": SHAPES, "placements": PLACEMENTS, "deltaT": 0.005,
               "writeInterval": 1, "writePrecision": 17,
               "startFrom": "latestTime", **parameters}
    return fsiCase.Case(path, **options).set_up()


def result(folder):
    """Contents of the files of a written time, by name; without uniform/time,
    which has the run's clock."""
    found = {}
    for parent, _, files in os.walk(folder):
        for name in files:
            path = os.path.join(parent, name)
            key = os.path.relpath(path, folder)
            if key != "uniform/time":
                with open(path, "rb") as stream:
                    found[key] = stream.read()
    return found
