#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the validation cases named, or all but the long ones, and writes
table.md.

    validate.py [-properties ENTRIES] [NAME...]

The cases are in the modules beside this one; references stand there.
"""

import argparse
import math
import sys
import time

import airfoil
import budget
import capsuleInShear
import capsuleInTube
import cavity
import common
import cylinder
import denseCells
import dilute
import discs
import fixedWalls
import flagInStream
import flap
import lubrication
import migration
import movingFrame
import oscillatingSphere
import pairInShear
import redCell
import resistances
import rigidStiff
import scalars
import settlingSphere
import shearBox
import softDisc
import suspension
import tether
import timeOrder
import timeStep
import vessel
import wallFilms
import wetRebound

MODULES = (budget, cavity, cylinder, discs, lubrication, migration, softDisc,
           timeOrder, timeStep, fixedWalls, shearBox, settlingSphere,
           rigidStiff, oscillatingSphere, pairInShear, resistances,
           suspension, flap, vessel, dilute, scalars, redCell, movingFrame,
           flagInStream, airfoil, tether, denseCells, wetRebound,
           capsuleInTube, capsuleInShear, wallFilms)


def collected(name):
    """The functions of all modules' tables of this name."""
    return {key: function for module in MODULES
            for key, function in getattr(module, name, {}).items()}


# Run if nothing is named, and only if named
CASES, LONG = collected("CASES"), collected("LONG")


def order(rows):
    """Observed order from the last rows of a ladder: of the error, or of the
    differences where there is no reference."""
    if rows[-1].reference is None:
        values = [row.value for row in rows[-3:]]
        errors = [abs(a - b) for a, b in zip(values, values[1:])]
    else:
        errors = [abs(row.value - row.reference) for row in rows[-2:]]
    if len(errors) < 2 or min(errors) == 0:
        return ""
    n, m = (row.ladder[1] for row in rows[-2:])
    return f"{math.log(errors[0]/errors[1])/math.log(m/n):.1f}"


def comparison(row):
    """Columns "reference", "here" and "difference"."""
    here = f"{row.value:.5g}"
    if row.reference is None:
        return f" | {here} | "
    difference = row.value - row.reference
    percent = (f" ({100*difference/row.reference:+.2f} %)"
               if row.reference else "")
    return f"{row.reference:.5g} | {here} | {difference:+.2g}{percent}"


def line(row, rows):
    """A line of the table; rows: all up to this one."""
    ladder = [r for r in rows if r.ladder and row.ladder
              and r.ladder[0] == row.ladder[0]]
    return (f"| {row.what} | {row.grid} | {comparison(row)} | "
            + ("" if row.tolerance is None else
               f"{row.tolerance:.3g} {'ok' if row.passed else '**no**'}")
            + f" | {order(ladder) if ladder else ''} | "
            f"{row.minutes:.1f} |")


def main():
    """Runs the cases and writes the table after each row."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-properties", default="")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    common.Case.entries = " " + options.properties
    names = options.names
    every = {**CASES, **LONG}
    unknown = [name for name in names if name not in every]
    if unknown:
        sys.exit(f"Unknown cases {unknown}; there are {list(every)}")

    lines = ["| case | grid | reference | here | difference | tolerance "
             "| order | CPU minutes |", "|---|---|---|---|---|---|---|---|"]
    rows = []
    for name in names or CASES:
        for row in every[name]():
            rows.append(row)
            lines.append(line(row, rows))
            print(lines[-1], flush=True)
    target = "table.md" if not names else f"table-{'-'.join(names)}.md"
    with open(target, "w", encoding="ascii") as stream:
        stream.write("Made by tutorials/validation/Allrun on "
                     f"{time.strftime('%Y-%m-%d')}\n\n"
                     + "\n".join(lines) + "\n")
    failed = [row for row in rows if not row.passed]
    print(f"{len(rows) - len(failed)} rows within their tolerances, "
          f"{len(failed)} not")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
