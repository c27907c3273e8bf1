#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles a contact law of a user's own as in README, runs the first tutorial
with it, and expects what the law must do: the discs bounce off each other, no
energy is added, and the contact energy is the law's.

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
    environment = dict(os.environ, FSI_USER_LIB=folder)
    done = subprocess.run(["wmake", "-s", "libso", copy], env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=600, check=False)
    library = os.path.join(folder, "libsquareContact.so")
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

    without = make(folder, "without")
    try:
        fsiCase.run(without, "fsiPisoFoam")
        report.check("unknown without libs", False, "it runs")
    except RuntimeError as error:
        report.check("unknown without libs", "square" in str(error)
                     and "elastic" in str(error), str(error))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
