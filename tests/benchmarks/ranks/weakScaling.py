#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Weak scaling: each rank has 256^2 cells with 100 discs on 40 % of them, or
48^3 cells with 12 spheres, on more and more ranks. With -strong, boxes of
several such parts on one rank and on two.

    weakScaling.py FOLDER RESULTS [-ranks N] [-steps N] [-strong]

The machine may have fewer cores than ranks: what counts is processor time
outside of MPI, memory, messages and bytes of each rank and step, see
countMessages.py. All sides are periodic, so that a rank has
the same neighbours however many there are. FOLDER holds the cases; the tables
ranks2D.csv and ranks3D.csv, or strong2D.csv and strong3D.csv, go to RESULTS.
"""

import argparse
import csv
import math
import os
import re
import shutil
import statistics

import countMessages
import fsiCase
import results

FAST = """solvers
{
    p { solver cartesianMG; tolerance 1e-6; relTol 0; }
    U { solver PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0; }
}
PISO {}
"""

# Ranks in each direction
PARTS = {2: ((1, 1), (2, 1), (2, 2), (4, 2), (4, 4)),
         3: ((1, 1, 1), (2, 1, 1), (2, 2, 1), (2, 2, 2))}

# Boxes that are put on one rank and on two: parts in each direction
STRONG = {2: ((3, 3), (10, 10)), 3: ((2, 2, 2),)}

# Cells of a rank in each direction, and objects
LOAD = {2: (256, 100), 3: (48, 12)}

# Steps that are not counted: factors, agglomeration, first messages
WARM_UP = 2

# Of a rank and step: the file's column, and what it is in the table
COLUMNS = {"outside": "s outside MPI", "messages": "messages",
           "bytes": "bytes", "largest": "largest message",
           "partners": "partners", "collectives": "collectives",
           "collectiveBytes": "collective bytes",
           "largestCollective": "largest collective"}

OF_ONE = ("s outside MPI", "s outside MPI, largest", "MiB, largest")


def shapes(n_dims, h):
    """What is seeded."""
    if n_dims == 2:
        radius = math.sqrt(0.4/math.pi/LOAD[2][1])
        return (f"disc {{ shape {{ type circle; radius {radius:.8g}; }} "
                "material { density 1000; E 2e4; } }")
    return (f"disc {{ shape {{ type sphere; radius {6*h:.8g}; }} "
            "material { type neoHookean; density 1000; E 2e3; } }")


def build(path, parts, steps):
    """A case of unit boxes side by side, in which objects move at random in a
    stream."""
    n_dims = len(parts)
    width, number = LOAD[n_dims]
    h = 1/width
    kind = "packed; sweeps 20" if n_dims == 2 else "random; maxAttempts 100000"
    case = fsiCase.Case(
        path, box=(0,)*n_dims + parts, cells=tuple(width*n for n in parts),
        cyclic="xyz"[:n_dims], density=1000, viscosity=0.01,
        velocity="(1 0 0)", shapes=shapes(n_dims, h),
        properties="coupling { passes 2; passTolerance 1e-12; }\n",
        placements=f"discs {{ type {kind}; shape disc; velocity (1 0 0); "
                   "velocityPerturbation 0.5; number "
                   f"{number*math.prod(parts)}; minimumGap {h}; wallGap {h}; "
                   "}",
        deltaT=0.25*h, endTime=0.25*h*(steps + 0.5), timePrecision=10,
        writeFormat="binary", libs='("libFastPoisson.so")')
    case.file("system/fvSolution", FAST)
    return case.set_up()


def measured(parts, rows, iterations):
    """A row of the table: means over ranks of medians over steps, and the
    largest rank."""
    n_dims = len(parts)
    width, number = LOAD[n_dims]
    found = {"ranks": len(rows),
             "cells": " x ".join(str(width*n) for n in parts),
             "objects": number*math.prod(parts), "p iterations": iterations}
    for column, name in COLUMNS.items():
        # The first row is the start
        values = [statistics.median(step[column]
                                    for step in rank[1 + WARM_UP:])
                  for rank in rows]
        if "argest" not in name:
            found[name] = statistics.mean(values)
        found[name + ", largest" if "argest" not in name
              else name] = max(values)
    found["MiB, largest"] = max(rank[-1]["memory"] for rank in rows)/1024
    return found


def run(case, parts, ranks, first, options):
    """A row of the table, with ratios to the first one if there is one."""
    if math.prod(ranks) > 1:
        case.decompose(*ranks)
    counts = countMessages.counted(
        case, math.prod(ranks), countMessages.library(options.folder))
    iterations = statistics.median(
        int(n) for n in re.findall(
            r"(?m)^Time = .* p (\d+)",
            results.read(case.path, "log.fsiPisoFoam"))[WARM_UP:])
    row = measured(parts, counts, iterations)
    for name in OF_ONE:
        row[name + ", of one"] = row[name]/(first or row)[name]
    print("; ".join(f"{k} {v:.4g}" if isinstance(v, float) else f"{k} {v}"
                    for k, v in row.items()), flush=True)
    shutil.rmtree(os.path.join(case.path, "counts"))
    return row


def table(n_dims, options):
    """All rows of a table."""
    rows = []
    for parts in (STRONG if options.strong else PARTS)[n_dims]:
        if not options.strong and math.prod(parts) > options.ranks:
            continue
        case = build(os.path.join(options.folder, f"ranks{n_dims}D"), parts,
                     options.steps)
        if options.strong:
            one = run(case, parts, (1,)*n_dims, None, options)
            two = run(case, parts, (2,) + (1,)*(n_dims - 1), one, options)
            rows += [one, two]
        else:
            rows.append(run(case, parts, parts, (rows or [None])[0], options))
        shutil.rmtree(case.path)
    return rows


def main():
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("folder", "results"):
        parser.add_argument(name)
    parser.add_argument("-ranks", type=int, default=16)
    parser.add_argument("-steps", type=int, default=10)
    parser.add_argument("-dimensions", type=int, nargs="+", default=(2, 3))
    parser.add_argument("-strong", action="store_true")
    options = parser.parse_args()
    name = "strong" if options.strong else "ranks"
    for n_dims in options.dimensions:
        rows = table(n_dims, options)
        path = os.path.join(options.results, f"{name}{n_dims}D.csv")
        with open(path, "w", encoding="ascii", newline="") as stream:
            writer = csv.DictWriter(stream, list(rows[0]))
            writer.writeheader()
            for row in rows:
                writer.writerow({k: f"{v:.4g}" if isinstance(v, float) else v
                                 for k, v in row.items()})
        print(f"{path}: {len(rows)} rows", flush=True)


if __name__ == "__main__":
    main()
