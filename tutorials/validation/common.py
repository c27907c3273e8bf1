# SPDX-License-Identifier: GPL-3.0-or-later
"""What the validation cases share."""

import os

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

    def text(self, name, text):
        """Writes a file without a header."""
        with open(os.path.join(self.path, name), "w",
                  encoding="ascii") as stream:
            stream.write(text)

    def replace(self, name, old, new):
        """Replaces a text that must be in a file."""
        text = results.read(self.path, name)
        if old not in text:
            raise ValueError(f"{self.path}/{name} has no '{old}'")
        self.text(name, text.replace(old, new))

    def set_field(self, name, kind, cells):
        """Writes the value of each cell, as text, as the start of a field."""
        zero = "(0 0 0)" if kind == "vector" else "0"
        self.replace(f"0/{name}", f"internalField uniform {zero};",
                     f"internalField nonuniform List<{kind}>\n"
                     f"{len(cells)}\n(\n" + "\n".join(cells) + "\n);")

    def set_velocity(self, velocity):
        """Starts from a velocity (u, v) that is a function of the place."""
        x0, y0, _, _ = self.values["box"]
        nx, ny = self.values["cells"]
        h = self.spacing()
        places = ((x0 + (i + 0.5)*h, y0 + (j + 0.5)*h)
                  for j in range(ny) for i in range(nx))
        self.set_field("U", "vector",
                       ["({!r} {!r} 0)".format(*velocity(*place))
                        for place in places])

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

    def spacing(self):
        """Length of a cell."""
        x0, _, x1, _ = self.values["box"]
        return (x1 - x0)/self.values["cells"][0]


class Field:
    """A cell field of a written time of a case, the last by default."""

    def __init__(self, case, name, component=0, time=None):
        time = time or results.times(case.path)[-1]
        flat = results.field(case.path, time, name)
        self.nx, ny = case.values["cells"]
        stride = len(flat)//(self.nx*ny)
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


def placed(shape, *centres):
    """Placement of objects at points."""
    objects = " ".join(f"{{ centre ({x} {y} 0); }}" for x, y in centres)
    return f"all {{ type listed; shape {shape}; objects ({objects}); }}"


def disc(radius, material, more=""):
    """The shape "disc"."""
    return (f"disc {{ shape {{ type circle; radius {radius}; }} "
            f"material {{ {material} }} {more} }}")


def at(rows, key, value, wanted):
    """"wanted" where "key" passes a value; rows in order."""
    for a, b in zip(rows, rows[1:]):
        if (a[key] - value)*(b[key] - value) <= 0 and a[key] != b[key]:
            s = (value - a[key])/(b[key] - a[key])
            return a[wanted] + s*(b[wanted] - a[wanted])
    raise ValueError(f"{key} does not pass {value}")
