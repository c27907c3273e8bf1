#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of doc/performance.md: runs cases, writes CSV and a plot.

    tables.py FOLDER RESULTS [-steps N] [-cells N] [-ranks N] TABLE...

TABLE: table6.1, table6.2, stock, profile, coupling, many, and those of
tables3D. Rows of more than -cells cells are left out and named. FOLDER holds
the cases, RESULTS the files.
"""

import argparse
import csv
import os

import fsiCase
import measure
import plot
import scenarios
import tables3D

# Seconds per step of the thesis, tables 6.1 and 6.2: (scenario, cells across,
# small objects)
THESIS_1 = {
    **{(1, 640, n): t for n, t in
       ((20, 9.21), (40, 10.13), (80, 16.58), (160, 9.09))},
    **{(2, 640, n): t for n, t in
       ((20, 9.72), (40, 10.02), (80, 9.14), (160, 10.17))},
    **{(3, 1280, n): t for n, t in
       ((40, 26.96), (80, 24.96), (160, 23.88), (320, 24.76), (640, 22.26))},
}
THESIS_2 = {
    (1, 80, 2): 0.02, (1, 160, 7): 0.16, (1, 320, 32): 1.22,
    (1, 640, 122): 8.60,
    (2, 80, 7): 0.07, (2, 160, 25): 0.39, (2, 320, 118): 2.39,
    (2, 640, 469): 21.20,
    (3, 160, 18): 0.02, (3, 320, 72): 0.14, (3, 640, 312): 0.79,
    (3, 1280, 1296): 9.50,
}

# Ratio to stock icoFoam with GAMG: (scenario, cells across, objects, kind)
STOCK = ((1, 320, 80, "weak"), (1, 320, 80, "default"),
         (1, 640, 160, "weak"), (1, 640, 160, "default"),
         (3, 1280, 1296, "default"))

# Grid scaling at a fixed number of cells per object
PROFILE = ((1, 160, 10, "default"), (1, 320, 40, "default"),
           (1, 640, 160, "default"), (1, 1280, 640, "default"))


class Tables:
    """Runs rows and keeps what they gave."""

    def __init__(self, folder, target, options):
        self.folder = folder
        self.target = target
        self.options = options
        os.makedirs(target, exist_ok=True)

    def row(self, number, width, objects, kind="default", stock=False):
        """One case: a dictionary, or None if it is too large."""
        box = scenarios.BOX[number]
        cells = width*width*(box[3] - box[1])//(box[2] - box[0])
        name = f"{number}-{width}-{objects}-{kind}"
        if self.left_out(name, cells):
            return None
        case = scenarios.Scenario(os.path.join(self.folder, name), number,
                                  width, objects, self.options.steps, kind)
        row = {"scenario": number, "Nx": case.size[0], "Ny": case.size[1],
               "objects": objects, "kind": kind,
               **self.measured(case, cells)}
        if stock:
            seconds = self.stock(case)["seconds"]
            row["icoFoam seconds/step"] = seconds
            row["ratio"] = row["seconds/step"]/seconds
        return row

    def left_out(self, name, cells):
        """True, and a word of it, if a row has too many cells."""
        if cells > self.options.cells:
            print(f"left out: {name}, {cells} cells", flush=True)
            return True
        print(f"{name}: ", end="", flush=True)
        return False

    def measured(self, case, cells):
        """Sets a case up, runs it, and what that gave."""
        case.set_up()
        ranks = self.options.ranks
        if ranks > 1:
            self.decompose(case, ranks)
        found = measure.run_steps(case.path, "fsiPisoFoam", ranks=ranks)
        print(f"{found['seconds']:.3g} s/step", flush=True)
        return {"ranks": ranks,
                "seconds/step": found["seconds"], "steps": found["steps"],
                "us/step/cell": 1e6*found["seconds"]/cells,
                "pressure iterations": found["iterations"],
                "MiB": found["memory"],
                **{f"{part} share": share for part, share in
                   measure.shares(case.path).items() if share > 0}}

    def stock(self, case):
        """The same by icoFoam with GAMG: what measure.run_steps gives."""
        other = case.stock(case.path + "-stock")
        ranks = self.options.ranks
        if ranks > 1:
            self.decompose(other, ranks)
        found = measure.run_steps(other.path, "icoFoam", ranks=ranks)
        print(f"icoFoam: {found['seconds']:.3g} s/step", flush=True)
        return found

    @staticmethod
    def decompose(case, ranks):
        """Slabs across the longest direction, the first of equal ones: the
        fewer objects reach from one to the other."""
        cells = case.values["cells"]
        longest = max(range(len(cells)), key=cells.__getitem__)
        parts = [1]*len(cells)
        parts[longest] = ranks
        case.decompose(*parts, options=["-force"])

    def write(self, name, rows):
        """RESULTS/name.csv; numbers with four digits."""
        rows = [row for row in rows if row]
        if not rows:
            return
        columns = list(dict.fromkeys(k for row in rows for k in row))
        path = os.path.join(self.target, name + ".csv")
        with open(path, "w", encoding="ascii", newline="") as stream:
            table = csv.DictWriter(stream, columns, restval="")
            table.writeheader()
            for row in rows:
                table.writerow({k: f"{v:.4g}" if isinstance(v, float) else v
                                for k, v in row.items()})
        print(f"{path}: {len(rows)} rows", flush=True)

    def thesis(self, name, expected, x_label, x_of):
        """A table of the thesis, beside its figures."""
        rows = []
        for (number, width, objects), seconds in expected.items():
            row = self.row(number, width, objects)
            if row:
                row["thesis seconds/step"] = seconds
                row["thesis/here"] = seconds/row["seconds/step"]
                rows.append(row)
        self.write(name, rows)
        curves = {}
        for row in rows:
            for source, key in (("here", "seconds/step"),
                                ("thesis", "thesis seconds/step")):
                curves.setdefault(
                    f"scenario {row['scenario']}, {source}", []
                ).append((x_of(row), row[key]))
        if curves:
            plot.loglog(os.path.join(self.target, name + ".svg"), curves,
                        x_label, "seconds per step")

    def table(self, name):
        """One of the tables by its name."""
        if name == "table6.1":
            self.thesis(name, THESIS_1, "objects", lambda r: r["objects"])
        elif name == "table6.2":
            self.thesis(name, THESIS_2, "cells", lambda r: r["Nx"]*r["Ny"])
        elif name == "stock":
            self.write(name, [self.row(*r, stock=True) for r in STOCK])
        elif name == "profile":
            rows = [r for r in (self.row(*r) for r in PROFILE) if r]
            self.write(name, rows)
            parts = {k for r in rows for k in r if k.endswith(" share")}
            plot.loglog(
                os.path.join(self.target, name + ".svg"),
                {part: [(r["Nx"]*r["Ny"], r["seconds/step"]*r[part])
                        for r in rows if r.get(part, 0) > 0]
                 for part in sorted(parts)},
                "cells", "seconds per step")
        elif name in tables3D.NAMES:
            self.write(name, tables3D.table(self, name))
        elif name == "coupling":
            self.write(name, self.coupling())
        else:
            self.write(name, self.many())

    def coupling(self):
        """Iterations of the pressure equation with the default coupling, discs
        on 40 % of the area, soft and stiff."""
        rows = []
        for E in (2e2, 2e6):
            for objects in (1, 16, 100, 1000):
                path = os.path.join(self.folder, f"discs-{E:g}-{objects}")
                case = Discs(path, objects, E, self.options.steps)
                if case.n**2 > self.options.cells:
                    print(f"left out: {objects} discs, {case.n**2} cells")
                    continue
                case.set_up()
                found = measure.run_steps(case.path, "fsiPisoFoam")
                rows.append({"cells": f"{case.n}^2", "discs": objects, "E": E,
                             "pressure iterations": found["iterations"],
                             "seconds/step": found["seconds"],
                             **{f"{k} share": v for k, v in
                                measure.shares(case.path).items()}})
                print(f"{objects} discs, E {E:g}: {found['iterations']} "
                      "iterations", flush=True)
        return rows

    def many(self):
        """10,000 discs beside 100 discs of the same size in cells."""
        rows = []
        for objects, n in ((100, 256), (10000, 2560)):
            case = Discs(os.path.join(self.folder, f"many-{objects}"),
                         objects, 2e4, max(self.options.steps, 25), n)
            if n*n > self.options.cells:
                print(f"left out: {objects} discs, {n*n} cells")
                continue
            case.set_up()
            ranks = self.options.ranks
            if ranks > 1:
                self.decompose(case, ranks)
            found = measure.run_steps(case.path, "fsiPisoFoam", ranks=ranks)
            rows.append({"cells": f"{n}^2", "discs": objects, "ranks": ranks,
                         "seconds/step": found["seconds"],
                         "bytes per cell and rank":
                         found["memory"]*2**20/(n*n)*ranks})
        return rows


class Discs(fsiCase.Case):
    """Equal discs packed on 40 % of a driven cavity, at least 16 cells wide."""

    def __init__(self, path, objects, E, steps, n=None):
        radius = (0.4/3.14159265/objects)**0.5
        self.n = n or max(128, 16*round(8/radius/16))
        step = 0.25/self.n
        super().__init__(
            path, cells=(self.n, self.n), density=1000, viscosity=0.01,
            walls={"top": "(1 0 0)"},
            shapes=f"disc {{ shape {{ type circle; radius {radius:.6g}; }} "
                   f"material {{ density 1000; E {E}; }} }}",
            placements=("discs { type listed; shape disc; objects "
                        "( { centre (0.5 0.5 0); } ); }" if objects == 1 else
                        "discs { type packed; shape disc; number "
                        f"{objects}; minimumGap {1.0/self.n}; wallGap "
                        f"{1.0/self.n}; sweeps 20; }}"),
            deltaT=step, endTime=step*(steps + 0.5), timePrecision=10,
            libs='("libFastPoisson.so")',
        )
        self.file("system/fvSolution", scenarios.FAST)


def main():
    """Reads the command line."""
    names = ("table6.1", "table6.2", "stock", "profile", "coupling", "many",
             *tables3D.NAMES)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("results")
    parser.add_argument("tables", nargs="+", choices=names)
    parser.add_argument("-steps", type=int, default=25)
    parser.add_argument("-cells", type=int, default=10**7)
    parser.add_argument("-ranks", type=int, default=1)
    options = parser.parse_args()
    tables = Tables(options.folder, options.results, options)
    for name in options.tables:
        tables.table(name)


main()
