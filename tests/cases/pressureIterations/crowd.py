#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Iterations of the pressure equation with objects of the fluid's density on
40 % of a driven cavity: at most 21 to 1e-6, soft and stiff, few discs and many,
red cells, and on two ranks as many as on one. Films of up to 2.5 cells take up
to four of them.

    crowd.py FOLDER

The solver starts from the last pressure and its last change. In a closed box
the pressure has no level, and none may come of that in 600 steps.
"""

import math
import os
import re
import statistics
import sys

import fsiCase
import results

LIMIT = 21
STEPS = 6

# Area of an outline of radius 1
AREA = {"circle": math.pi, "biconcave": 0.891}

# Outline, number, cells per side, modulus over density times speed squared,
# viscosity, most iterations. In the last one friction stops the fluid in films
# within a step: 187 where their faces do not conduct by moving bodies
CASES = (("circle", 1, 64, 0.2, 0.01, LIMIT),
         ("circle", 16, 128, 0.2, 0.01, LIMIT),
         ("circle", 16, 128, 2e3, 0.01, LIMIT),
         ("circle", 64, 192, 0.2, 0.01, LIMIT),
         ("biconcave", 12, 256, 8, 0.01, LIMIT),
         ("circle", 64, 128, 2, 0.1, 150))


def crowd(path, outline, number, n, modulus, viscosity):
    """A case with objects packed at random, at least a cell apart."""
    radius = math.sqrt(0.4/AREA[outline]/number)
    step = 0.25/n
    return fsiCase.Case(
        path, cells=(n, n), density=1000, viscosity=viscosity,
        walls={"top": "(1 0 0)"},
        shapes=f"disc {{ shape {{ type {outline}; radius {radius:.6g}; }} "
               f"material {{ density 1000; E {1000*modulus}; }} }}",
        placements=("discs { type listed; shape disc; objects "
                    "( { centre (0.5 0.5 0); } ); }" if number == 1 else
                    f"discs {{ type packed; shape disc; number {number}; "
                    f"minimumGap {1/n}; wallGap {1/n}; sweeps 20; }}"),
        deltaT=step, endTime=step*(STEPS + 0.5), timePrecision=10,
        p_tolerance=1e-6)


def iterations(log):
    """Median over the steps after the first."""
    found = re.findall(r"(?m)^Time = .* p (\d+)", log)
    return statistics.median(int(n) for n in found[1:])


def check_level(report, folder):
    """Mean of the pressure over its range, at the end."""
    case = fsiCase.Case(
        os.path.join(folder, "level"), cells=(40, 40), viscosity=0.01,
        walls={"top": "(1 0 0)"}, deltaT=0.01, endTime=6,
        writeControl="timeStep", writeInterval=600,
        shapes="disc { shape { type circle; radius 0.15; } "
               "material { density 1; E 100; } }",
        placements="one { type listed; shape disc; "
                   "objects ({ centre (0.5 0.42 0); }); }").set_up()
    case.run("fsiPisoFoam")
    p = results.field(case.path, results.times(case.path)[-1], "p")
    level = sum(p)/len(p)/(max(p) - min(p))
    report.check("the pressure of a closed box keeps its level",
                 abs(level) < 0.01, f"{level} of its range")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("level", check_level, report, folder)
    for outline, number, n, modulus, viscosity, most in CASES:
        name = f"{number} {outline}, modulus {modulus:g}"
        case = crowd(os.path.join(folder, f"{outline}-{number}-{modulus:g}"),
                     outline, number, n, modulus, viscosity)
        log = (report.attempt(name, case.set_up)
               and report.attempt(name, case.run, "fsiPisoFoam"))
        if not log:
            continue
        count = iterations(log)
        print(f"    {name}: {count} iterations")
        report.check(name, count <= most, f"{count} iterations")
        if (number, modulus) == (16, 0.2):
            check_ranks(report, case, count)


def check_ranks(report, case, serial):
    """The same on two ranks."""
    case.file("system/decomposeParDict",
              "numberOfSubdomains 2; method hierarchical;\n"
              "hierarchicalCoeffs { n (2 1 1); delta 0.001; order xyz; }\n")
    name = "iterations on two ranks"
    log = (report.attempt(name, case.run, "decomposePar")
           and report.attempt(
               name, lambda: case.run("fsiPisoFoam", ranks=2)))
    if log:
        count = iterations(log)
        print(f"    on two ranks: {count}")
        report.check(name, count <= min(LIMIT, serial + 2),
                     f"{count}, {serial} on one")


if __name__ == "__main__":
    main(sys.argv[1])
