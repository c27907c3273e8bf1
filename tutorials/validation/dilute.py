# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscosity of a dilute suspension in a shear box, from the friction of the
walls and from the stress of the bodies (rheology.csv): a rigid sphere and a
rigid disc between walls that slide, ten radii apart, at Re 0.1. Einstein's
1 + 2.5 phi in three dimensions; in two it is 1 + 2 phi. And discs on 20 % of
the area, and 20 spheres, whose stress parts add up to the walls' stress."""

import math

import results
from common import Row, sheared, sphere

SIDE = 10


def shear(name, n_dims, cells, shapes, placements, end, step=0.02, **entries):
    """Runs a shear box of ten radii; mean of the columns of rheology.csv over
    the last quarter, and minutes."""
    case = sheared(
        f"dilute-{name}", (SIDE/2,)*n_dims, cells, viscosity=10,
        shapes=shapes, placements=placements,
        properties="output { rheology yes; } "
                   "contact { range 1; }",
        deltaT=step, endTime=end, writeInterval=end, p_tolerance=1e-9,
        U_tolerance=1e-10, **entries)
    minutes = case.solve(20000)
    rows = results.table(case.path, "rheology.csv")
    rows = rows[3*len(rows)//4:]
    return {key: sum(row[key] for row in rows)/len(rows)
            for key in rows[0]}, minutes


def einstein(cells=5):
    """One body."""
    for n_dims, name, shape, volume, exact, tolerance in (
            (3, "sphere", sphere(1, "type rigid; density 1;"), 4/3*math.pi,
             2.5, 0.03),
            (2, "disc", "disc { shape { type circle; radius 1; } "
             "material { type rigid; density 1; } }", math.pi, 2, None)):
        values, minutes = shear(
            name, n_dims, cells if n_dims == 3 else 2*cells, shape,
            f"a {{ type listed; shape {name}; objects "
            "({ centre (0.013 0.017 0.011); }); }", 3)
        phi = volume/SIDE**n_dims
        for what, column in (("walls", "wallViscosity"),
                             ("stresslets", "viscosity")):
            yield Row(f"a {name} in shear, intrinsic viscosity by {what}",
                      f"a/h = {cells}", exact, (values[column] - 1)/phi,
                      tolerance and tolerance*exact, minutes)


def discs():
    """The parts of the stress of a suspension of discs."""
    values, minutes = shear(
        "discs", 2, 6, "disc { shape { type circle; radius 1; } "
        "material { type rigid; density 1; } }",
        "a { type random; shape disc; number 6; seed 3; }", 6, 0.01)
    yield Row("six discs in shear, sum of the parts of the stress over the "
              "walls' stress", "a/h = 6", 1,
              values["viscosity"]/values["wallViscosity"], 0.03, minutes)


def spheres(cells=5):
    """The parts of the stress of a suspension of spheres."""
    values, minutes = shear(
        "spheres", 3, cells, sphere(1, "type rigid; density 1;"),
        "a { type random; shape sphere; number 20; seed 3; }", 3)
    yield Row("20 spheres in shear, sum of the parts of the stress over the "
              "walls' stress", f"a/h = {cells}", 1,
              values["viscosity"]/values["wallViscosity"], 0.01, minutes)
    yield Row("the same, viscosity by the walls", f"a/h = {cells}", None,
              values["wallViscosity"], None, minutes)


def dilute():
    """All."""
    yield from einstein()
    yield from discs()


CASES = {"dilute": dilute, "spheresInShear": spheres}
