# SPDX-License-Identifier: GPL-3.0-or-later
"""What the validation cases share."""

import math
import os
import re

import fsiCase
import results

FOLDER = "cases"


class Row:
    """A row of the table. reference: None where there is none. tolerance: as a
    difference from the reference; None where the figure is only reported.
    ladder: name of the rows that make a convergence study, and their number of
    cells."""

    def __init__(self, what, grid, reference, value, tolerance, minutes,
                 ladder=None):
        self.what = what
        self.grid = grid
        self.reference = reference
        self.value = value
        self.tolerance = tolerance
        self.minutes = minutes
        self.ladder = ladder

    @property
    def passed(self):
        """True if the value is within the tolerance, or there is none."""
        return (self.tolerance is None
                or abs(self.value - self.reference) <= self.tolerance)


class Case(fsiCase.Case):
    """A case in the folder of the cases.

    entries: of constant/fsiProperties, for all cases, after their own."""

    entries = ""

    def __init__(self, name, **parameters):
        parameters.setdefault("writeControl", "adjustableRunTime")
        parameters["properties"] = (parameters.get("properties", "")
                                    + self.entries)
        super().__init__(os.path.join(FOLDER, name), **parameters)

    def start_from(self, coarse):
        """Takes U and p of the last time of a case with half the cells."""
        time = results.times(coarse.path)[-1]
        nx, ny = coarse.values["cells"]
        for name, kind in (("U", "vector"), ("p", "scalar")):
            n = 3 if kind == "vector" else 1
            flat = results.field(coarse.path, time, name)
            cells = [" ".join(map(repr, flat[n*i:n*i + n]))
                     for i in range(nx*ny)]
            fine = [cells[i//2 + nx*(j//2)]
                    for j in range(2*ny) for i in range(2*nx)]
            self.set_field(name, kind, fine if n == 1 else
                           [f"({cell})" for cell in fine])
        return self

    def solve(self, limit=7200):
        """Sets up and runs; the minutes it took of the processor."""
        self.set_up()
        return self.solve_only(limit)

    def solve_only(self, limit=7200):
        """Runs what is set up."""
        self.run("fsiPisoFoam", limit=limit)
        return self.seconds["fsiPisoFoam"]/60

    def objects(self):
        """Rows of objects.csv."""
        return results.table(self.path, "objects.csv")

    def logged(self, pattern):
        """Whole numbers that a pattern finds in the log of the solver."""
        return [int(n) for n in re.findall(
            pattern, results.read(self.path, "log.fsiPisoFoam"))]

    def volume_change(self):
        """Largest change of the volume of a body, relative."""
        return max(row["areaChange"]
                   for row in results.table(self.path, "global.csv"))

    def state_of(self, shape):
        """The file with the state of the objects of a shape at the start, its
        text, and the positions of their nodes, one list per component: of one
        object. The file loses its check sums, so that it may be changed."""
        path = f"0/uniform/fsiObjects/{shape}"
        text = results.read(self.path, path)
        self.replace(path, text, results.without_sums(text))
        text = results.without_sums(text)
        flat = results.numbers(text, "positions")
        n = len(flat)//self.dimensions()
        return path, text, [flat[i:i + n] for i in range(0, len(flat), n)]

    def stretch(self, shape, *factors):
        """Draws the one object of a shape about the mean of its nodes, by a
        factor along each axis."""
        path, text, columns = self.state_of(shape)
        moved = []
        for column, factor in zip(columns, factors):
            centre = sum(column)/len(column)
            moved += [centre + (x - centre)*factor for x in column]
        start = text.index("positions")
        end = text.index(";", start)
        self.replace(path, text[start:end],
                     f"positions List<scalar> {len(moved)}("
                     + " ".join(map(repr, moved)) + ")")


class Field:
    """A cell field of a written time of a case, the last by default."""

    def __init__(self, case, name, component=0, time=None):
        time = time or results.times(case.path)[-1]
        flat = results.field(case.path, time, name)
        self.nx = case.values["cells"][0]
        stride = len(flat)//math.prod(case.values["cells"])
        self.values = flat[component::stride]
        self.origin = case.values["box"][:2]
        self.h = case.spacing()

    def at(self, x, y):
        """Linear interpolation between cell centres."""
        s = (x - self.origin[0])/self.h - 0.5
        t = (y - self.origin[1])/self.h - 0.5
        i, j = int(s), int(t)
        a, b = s - i, t - j
        v, k = self.values, i + self.nx*j
        return ((1 - b)*((1 - a)*v[k] + a*v[k + 1])
                + b*((1 - a)*v[k + self.nx] + a*v[k + self.nx + 1]))


def sheared(name, half, cells, **parameters):
    """A case of a shear flow of rate 1 along x, between walls that move, and
    periodic else. half: of the box, whose middle is 0; cells: to a length of
    1."""
    case = Case(
        name, box=tuple(-x for x in half) + tuple(half),
        cells=tuple(round(2*x*cells) for x in half),
        cyclic="x" if len(half) == 2 else "xz",
        walls={"top": f"({half[1]} 0 0)", "bottom": f"({-half[1]} 0 0)"},
        **parameters)
    case.set_velocity(lambda x, y, z=0: (y, 0, 0)[:len(half)])
    return case


def carried(x, y, z=0):
    """A listed object that this flow carries along."""
    return (f"{{ centre ({x!r} {y!r} {z!r}); velocity ({y!r} 0 0); "
            "angularVelocity (0 0 -0.5); }")


def placed(shape, *centres):
    """Placement of objects at points."""
    objects = " ".join("{{ centre ({} {} {}); }}".format(*centre, 0)
                       for centre in centres)
    return f"all {{ type listed; shape {shape}; objects ({objects}); }}"


def body(name, shape, material, more=""):
    """A shape of a name, with further entries."""
    return (f"{name} {{ shape {{ type {shape} }} "
            f"material {{ {material} }} {more} }}")


def disc(radius, material, more=""):
    """The shape "disc"."""
    return body("disc", f"circle; radius {radius};", material, more)


def sphere(radius, material, more=""):
    """The shape "sphere"."""
    return body("sphere", f"sphere; radius {radius};", material, more)


def wall_layers(case, time):
    """Mean velocity u in the cells along the lower and along the upper wall."""
    nx, ny = case.values["cells"][:2]
    u = Field(case, "U", 0, time).values
    layers = [[u[start:start + nx] for start in range(first, len(u), nx*ny)]
              for first in (0, nx*(ny - 1))]
    return [sum(map(sum, layer))/(nx*len(layer)) for layer in layers]


def at(rows, key, value, wanted):
    """"wanted" where "key" passes a value; rows in order."""
    for a, b in zip(rows, rows[1:]):
        if (a[key] - value)*(b[key] - value) <= 0 and a[key] != b[key]:
            s = (value - a[key])/(b[key] - a[key])
            return a[wanted] + s*(b[wanted] - a[wanted])
    raise ValueError(f"{key} does not pass {value}")
