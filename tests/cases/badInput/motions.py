#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects whose motion is prescribed: what cannot be ends in an error that
names them.

    motions.py FOLDER
"""

import os
import sys

import fsiCase
from refused import refused


def check_prescribed(report, folder):
    """Objects whose motions are prescribed: one with a velocity of its own, and
    one that is driven into another."""
    motions = {"still": "fixed;", "mover": "translating; velocity (1 0 0);"}
    case = fsiCase.Case(
        os.path.join(folder, "prescribed"), cells=(32, 32), deltaT=0.02,
        endTime=0.4, shapes=" ".join(
            f"{name} {{ shape {{ type circle; radius 0.15; }} material "
            f"{{ type rigid; density 1; }} motion {{ type {motion} }} }}"
            for name, motion in motions.items()),
        placements="a { type listed; objects ("
                   "{ shape mover; centre (0.3 0.5 0); } "
                   "{ shape still; centre (0.7 0.5 0); }); }")
    if report.attempt("set-up of prescribed objects", case.set_up):
        refused(report, "prescribed objects driven into each other", case,
                "fsiPisoFoam", ("FATAL ERROR", "Objects 0 of shape mover",
                                "1 of shape still", "overlap at time"))
    case.values["placements"] = case.values["placements"].replace(
        "0.7 0.5 0);", "0.7 0.5 0); velocity (0.1 0 0);")
    case.write()
    refused(report, "velocity of a prescribed object", case, "seedObjects",
            ("FATAL IO ERROR", "seedObjectsDict", "'velocity'", "placement a",
             "object 1", "motion"))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_prescribed(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
