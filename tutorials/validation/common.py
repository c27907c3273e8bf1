# SPDX-License-Identifier: GPL-3.0-or-later
"""What the validation cases share."""

import os

import fsiCase
import results

FOLDER = "cases"


class Row:
    """A row of the table. tolerance: as a difference from the reference; None
    where the figure is only reported. ladder: name of the rows that make a
    convergence study, and their number of cells."""

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
    """A case in the folder of the cases."""

    def __init__(self, name, **parameters):
        parameters.setdefault("writeControl", "adjustableRunTime")
        super().__init__(os.path.join(FOLDER, name), **parameters)

    def replace(self, name, old, new):
        """Replaces a text that must be in a file."""
        path = os.path.join(self.path, name)
        text = results.read(path)
        if old not in text:
            raise ValueError(f"{path} has no '{old}'")
        with open(path, "w", encoding="ascii") as stream:
            stream.write(text.replace(old, new))

    def start_from(self, coarse):
        """Takes U and p of the last time of a case with half the cells."""
        time = results.times(coarse.path)[-1]
        nx, ny = coarse.values["cells"]
        for name, zero, kind in (("U", "(0 0 0)", "vector"),
                                 ("p", "0", "scalar")):
            n = 3 if kind == "vector" else 1
            flat = results.numbers(results.read(coarse.path, time, name),
                                   "internalField")
            cells = [flat[n*i:n*i + n] for i in range(nx*ny)]
            fine = (cells[i//2 + nx*(j//2)]
                    for j in range(2*ny) for i in range(2*nx))
            text = "\n".join("(" + " ".join(map(repr, c)) + ")" if n == 3
                             else repr(c[0]) for c in fine)
            self.replace(f"0/{name}", f"internalField uniform {zero};",
                         f"internalField nonuniform List<{kind}>\n"
                         f"{4*nx*ny}\n(\n{text}\n);")
        return self

    def solve(self, limit=7200):
        """Sets up and runs; the minutes it took of the processor."""
        self.set_up()
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
    """A cell field of the last written time of a case."""

    def __init__(self, case, name, component=0):
        time = results.times(case.path)[-1]
        flat = results.numbers(results.read(case.path, time, name),
                               "internalField")
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
