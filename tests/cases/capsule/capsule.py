#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A capsule, a neo-Hookean membrane inside the fluid, in simple shear flow in
three dimensions, against published deformations.

    capsule.py FOLDER

Units: the radius, the shear rate and the fluid's density are 1. The Reynolds
number is 0.05, the walls are 4 radii from the centre. The capillary number is
mu times rate times radius over the shear modulus.
"""

import filecmp
import math
import os
import re
import subprocess
import sys

import adhesion
import fsiCase
import results
import steps
from shearCase import HALF, STEP, STIFF, VISCOSITY, capsule

# Taylor's deformation at the time 1, capillary number 0.3: Ramanujan &
# Pozrikidis 1998, J. Fluid Mech. 361, 117; Doddi & Bagchi 2008, Int. J.
# Multiphase Flow 34, 966; Huet & Wachs 2023, J. Comput. Phys. 477, 111887
PUBLISHED = (0.3055, 0.3123)

# It is too large by 2 to 5 %, see doc/choices.md
EXCESS = 1.08

# A membrane whose viscosity is that of the fluid times the radius
VISCOUS = f"membraneViscosity {VISCOSITY}; viscousModulus {20*VISCOSITY};"


def check_deformation(report, folder):
    """Deformation and volume at 5 cells to the radius."""
    case = capsule(folder, "shear", writeInterval=25)
    case.run("fsiPisoFoam")
    row = results.table(case.path, "objects.csv")[-1]
    D = row["deformation"]
    least, most = PUBLISHED
    print(f"    D = {D:.4f} at the time 1, published {least} to {most}; "
          f"{case.seconds['fsiPisoFoam']:.0f} s")
    report.check("the deformation is at most 8 % above the literature",
                 least < D < EXCESS*most, D)
    report.check("it turns and is stretched", row["stretch"] > 1.2
                 and row["phaseZ"] < results.table(
                     case.path, "objects.csv")[0]["phaseZ"] - 0.1
                 and 0.3 < row["inclination"] < 0.8, str(row))
    check_profiles(report, case)
    change = max(row["areaChange"]
                 for row in results.table(case.path, "global.csv"))
    report.check("the volume stays", change < 1e-6, change)
    text = case.run("checkObjects")
    report.check("objects are sound", "Objects are sound" in text, text[-300:])


def check_profiles(report, case):
    """etc/profiles: Einstein's viscosity, and the fraction of the box."""
    text = subprocess.run(
        [os.path.join(os.path.dirname(os.path.abspath(__file__)),
                      "../../../etc/profiles"), case.path, "-from", "0.5"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        check=False).stdout
    values = {line[:40].strip(): float(line[40:])
              for line in text.splitlines() if not line.startswith("/")}
    fraction = 4/3*math.pi/(2*HALF)**3
    report.check(
        "etc/profiles", len(values) == 7 and 1 + fraction
        < values["apparent viscosity over the fluid's"] < 1 + 4*fraction
        and abs(values["volume fraction, tube haematocrit"]/fraction - 1)
        < 0.02, text)


def check_contrast(report, folder):
    """A drop that is five times as viscous, with dt nu/h^2 of 128 inside.
    Taylor's D with walls (Shapira & Haber 1990, Int. J. Multiphase Flow 16,
    305) is 0.059; with 4 cells to the radius D of an equally viscous drop is
    16 % too large (doc/choices.md)."""
    case = capsule(folder, "contrast", cells=4, capillary=0.05, law="drop",
                   modulus="tension", deltaT=0.08, endTime=2,
                   material=f"innerViscosity {5*VISCOSITY};")
    case.run("fsiPisoFoam")
    D = [row["deformation"] for row in results.table(case.path, "objects.csv")]
    print(f"    D = {D[-1]:.4f}")
    report.check("a viscous drop deforms smoothly", all(
        a < b for a, b in zip(D, D[1:])) and 0.05 < D[-1] < 1.2*0.059,
                 str(D[::5]))
    with open(os.path.join(case.path, "log.fsiPisoFoam"),
              encoding="utf-8") as log:
        lines = [line for line in log if line.startswith("Time =")]
    cycles = [int(re.search(r" U (\d+) ", line)[1]) for line in lines]
    report.check("one pass, and few solutions by multigrid", max(cycles) < 12
                 and not any("passes" in line for line in lines), str(cycles))


def check_thin(report, folder):
    """A drop with a fifth of the viscosity around: D of Taylor, 0.0525 times
    1.02 for the walls, and 16 % as above. Where the explicit part of the stress
    is larger than the implicit one it bursts."""
    case = capsule(folder, "thin", cells=4, capillary=0.05, law="drop",
                   modulus="tension", deltaT=0.08, endTime=2.4,
                   material=f"innerViscosity {VISCOSITY/5};")
    case.run("fsiPisoFoam")
    D = [row["deformation"] for row in results.table(case.path, "objects.csv")]
    late = D[len(D)//3:]
    report.check("a thin drop keeps its shape",
                 0.05 < min(late) and max(late) < 1.4*0.0535, str(D[::3]))


def check_ranks(report, folder):
    """Two ranks, cut across a cyclic direction or along the walls, and three,
    with another viscosity inside and in the membrane."""
    short = {"cells": 4, "endTime": 5*STEP, "writeInterval": 5,
             "writePrecision": 17, "p_tolerance": 1e-12, "U_tolerance": 1e-12}
    viscous = {"material": f"innerViscosity {3*VISCOSITY}; {VISCOUS}"}
    for parts, sheet in (((2, 1, 1), viscous), ((1, 2, 1), viscous),
                         ((3, 1, 1), viscous), ((2, 1, 1), STIFF)):
        serial = capsule(folder, "serial", **short, **sheet)
        serial.run("fsiPisoFoam")
        case = capsule(folder, "ranks", **short, **sheet)
        case.decompose(*parts)
        case.run("fsiPisoFoam", ranks=max(parts))
        case.run("reconstructPar", "-latestTime")
        error = results.difference(serial.path, case.path)
        tables = [results.table(c.path, "objects.csv")[-1]
                  for c in (serial, case)]
        what = f"ranks {parts} {'stiff ' if sheet is STIFF else ''}have"
        report.check(f"{what} the rows of one", all(
            abs(tables[0][key] - tables[1][key]) < 1e-7
            for key in ("phaseX", "phaseZ", "inclination", "stretch")),
                     str(tables))
        report.check(f"{what} the nodes of one", error < 1e-8,
                     f"{error:.2e} of the size")


def pressed(folder, name, **more):
    """A capsule that the flow carries against a sphere."""
    values = {"deltaT": 2*STEP, "endTime": 4, "writeInterval": 25,
              "writePrecision": 17, "p_tolerance": 1e-5, "U_tolerance": 1e-6,
              "motion": "motion { type fixed; }", **more}
    motion = values.pop("motion")
    return fsiCase.Case(
        os.path.join(folder, name), box=(-4, -2, -2, 4, 2, 2),
        cells=(32, 16, 16), viscosity=VISCOSITY, cyclic="xz",
        velocity="(1 0 0)",
        properties="output { crossing warn; } drivingForce "
                   "{ type meanVelocity; velocity (1 0 0); }",
        shapes="capsule { shape { type sphere; radius 1; } material { type "
               f"membrane; law neoHookean; density 1; shearModulus "
               f"{VISCOSITY/0.3}; bendingModulus {0.01*VISCOSITY}; }} }} "
               "ball { shape { type sphere; radius 0.8; } "
               f"material {{ type rigid; density 1; }} {motion} }}",
        placements="a { type listed; shape capsule; objects "
                   "({ centre (-1.1 0 0); }); } b { type listed; shape ball; "
                   "objects ({ centre (1 0.1 0); }); }", **values).set_up()


def check_walls(report, folder):
    """No node gets into a sphere to which the flow presses a capsule: without
    ghosts and defence some do. A sphere that moves freely gets the forces
    of the capsule, on one rank and on two."""
    text = pressed(folder, "pressed").run("fsiPisoFoam")
    inside = re.findall(r"inside other objects: (\d+) of (\d+)", text)
    report.check("no node is inside a sphere", len(inside) == 4 and all(
        n == "0" and int(of) > 200 for n, of in inside), str(inside))

    short = {"endTime": 10*STEP, "writeInterval": 5, "motion": "",
             "p_tolerance": 1e-12, "U_tolerance": 1e-12}
    serial = pressed(folder, "freeBall", **short)
    serial.run("fsiPisoFoam")
    for parts in ((2, 1, 1), (1, 2, 1)):
        case = pressed(folder, "freeOnRanks", **short)
        case.decompose(*parts)
        case.run("fsiPisoFoam", ranks=2)
        case.run("reconstructPar", "-latestTime")
        error = results.difference(serial.path, case.path)
        report.check(f"beside a free sphere ranks {parts} have the nodes of "
                     "one", error < 1e-8, f"{error:.2e} of the size")


def check_restart(report, folder):
    """A run that was stopped ends as the run without a stop, on one rank and on
    two; a viscous capsule with another viscosity inside and bending, and a
    stiff one."""
    more = {"cells": 4, "writeInterval": 3, "writeFormat": "binary",
            "timePrecision": 10}
    viscous = {**more, "deltaT": 0.1*STEP, "material":
               f"bendingModulus {0.01*VISCOSITY}; "
               f"innerViscosity {3*VISCOSITY}; {VISCOUS}"}
    stiff = {**more, "deltaT": STEP, **STIFF}
    for ranks, sheet in ((1, viscous), (2, viscous), (1, stiff), (2, stiff)):
        name = f"{ranks}{'stiff' if sheet is stiff else ''}"
        step = sheet["deltaT"]
        whole = capsule(folder, f"whole{name}", endTime=6*step, **sheet)
        stopped = capsule(folder, f"stopped{name}", endTime=3*step, **sheet)
        for case in (whole, stopped):
            if ranks > 1:
                case.decompose(ranks, 1, 1)
            case.run("fsiPisoFoam", ranks=ranks)
        stopped.control(startFrom="latestTime", endTime=6*step)
        stopped.run("fsiPisoFoam", ranks=ranks)
        rank = "processor0" if ranks > 1 else ""
        files = [os.path.join(rank, results.times(
            os.path.join(whole.path, rank))[-1], name)
            for name in ("U", "p", "phi", "uniform/fsiObjects/capsule")]
        differ = [f for f in files if not filecmp.cmp(
            os.path.join(whole.path, f), os.path.join(stopped.path, f), False)]
        report.check(f"restart on {name}: the same to the last bit",
                     not differ, str(differ))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("shear", check_deformation, report, folder)
    report.attempt("contrast", check_contrast, report, folder)
    report.attempt("thin", check_thin, report, folder)
    report.attempt("ranks", check_ranks, report, folder)
    report.attempt("walls", check_walls, report, folder)
    report.attempt("adhesion", adhesion.check, report, folder)
    report.attempt("restart", check_restart, report, folder)
    report.attempt("refused", steps.refused, report, folder)
    report.attempt("stiff", steps.stiff, report, folder)
    report.attempt("adjusted", steps.adjusted, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
