#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles a library of a user's own as in doc/extending.md. With its contact
law the first tutorial must do what the law says: the discs bounce off each
other, no energy is added, and the contact energy is the law's. With its load
discs swim apart.

    law.py FOLDER LIBRARY
"""

import os
import shutil
import subprocess
import sys

import fsiCase
import results

LAW = "contact { law { type square; stiffness 2e4; } }\n"


def compile_library(folder, source):
    """wmake of a copy of the library; the path of the result."""
    copy = os.path.join(folder, "library")
    shutil.copytree(source, copy, ignore=shutil.ignore_patterns(
        "lnInclude", "linux*"))
    environment = dict(os.environ, FOAM_USER_LIBBIN=folder)
    done = subprocess.run(["wmake", "-s", "libso", copy], env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=600, check=False)
    library = os.path.join(folder, "libuserLaws.so")
    if done.returncode or not os.path.exists(library):
        raise RuntimeError(done.stdout[-600:])
    return library


def make(folder, name, *libraries):
    """The tutorial with the law; libraries go into controlDict."""
    case = fsiCase.tutorial("01-twoDiscs", os.path.join(folder, name))
    names = " ".join(f'"{path}"' for path in libraries)
    with open(os.path.join(case, "system/controlDict"), "a",
              encoding="ascii") as stream:
        stream.write(f"libs ({names});\n")
    with open(os.path.join(case, "constant/fsiProperties"), "a",
              encoding="ascii") as stream:
        stream.write(LAW)
    return case


def check_run(report, case):
    """What the law did."""
    rows = results.table(case, "global.csv")
    energies = [r["kineticEnergy"] + r["elasticEnergy"] + r["contactEnergy"]
                for r in rows]
    contact = max(r["contactEnergy"] for r in rows)
    print(f"    energy {energies[0]:.4f} to {energies[-1]:.4f} J, of contact "
          f"at most {contact:.4f} J, smallest gap "
          f"{min(r['smallestGap'] for r in rows):.4f} m")
    report.check("the law acts", contact > 0.01, f"{contact}")
    report.check("no energy is added", max(energies) <= 1.001*energies[0],
                 f"{max(energies)} after {energies[0]}")
    report.check("the discs part", rows[-1]["contacts"] == 0, "they stick")
    fsiCase.run(case, "checkObjects")
    report.check("they never overlap", True)


def check_load(report, folder, library):
    """The load pushes discs of even ids forwards, those of odd ids back."""
    case = fsiCase.Case(
        os.path.join(folder, "load"), cells=(32, 32), viscosity=0.1,
        shapes="disc { shape { type circle; radius 0.1; } material { type "
               "rigid; density 1; } motion { type free; loads { swim { type "
               "swimming; thrust 1e-3; } } } }",
        placements="a { type listed; shape disc; objects ({ centre (0.5 0.3 "
                   "0); } { centre (0.5 0.7 0); }); }",
        properties="output { objectsEvery 1; }",
        deltaT=0.01, endTime=0.1, libs=f'("{library}")').set_up()
    case.run("fsiPisoFoam")
    speeds = {row["object"]: row["velocityX"]
              for row in results.table(case.path, "objects.csv")[-2:]}
    report.check("discs swim apart", speeds[0] > 1e-3 and
                 abs(speeds[0] + speeds[1]) < 1e-6*speeds[0], f"{speeds}")


def main(folder, source):
    """The checks."""
    report = fsiCase.Report()
    library = report.attempt("the library compiles", compile_library, folder,
                             source)
    if library is None:
        return
    case = make(folder, "case", library)
    if report.attempt("fsiPisoFoam runs", fsiCase.run, case, "fsiPisoFoam"):
        report.attempt("results", check_run, report, case)

    report.attempt("a load of one's own", check_load, report, folder, library)

    without = make(folder, "without")
    try:
        fsiCase.run(without, "fsiPisoFoam")
        report.check("unknown without libs", False, "it runs")
    except RuntimeError as error:
        report.check("unknown without libs", "square" in str(error)
                     and "elastic" in str(error), str(error))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
