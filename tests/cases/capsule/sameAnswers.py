# SPDX-License-Identifier: GPL-3.0-or-later
"""Capsules in shear flow have one answer on any number of ranks, and after a
restart."""

import filecmp
import os

import results
from shearCase import STEP, STIFF, VISCOSITY, capsule

# A membrane whose viscosity is that of the fluid times the radius
VISCOUS = f"membraneViscosity {VISCOSITY}; viscousModulus {20*VISCOSITY};"


def ranks(report, folder, plane=False):
    """Two ranks, cut across a cyclic direction or along the walls, and three,
    with another viscosity inside and in the membrane."""
    short = {"plane": plane, "cells": 4, "endTime": 5*STEP, "writeInterval": 5,
             "writePrecision": 17, "p_tolerance": 1e-12, "U_tolerance": 1e-12}
    viscous = {"material": f"innerViscosity {3*VISCOSITY}; {VISCOUS}"}
    keys = ("centroidX", "phase", "inclination") if plane else (
        "phaseX", "phaseZ", "inclination", "stretch")
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
            for key in keys), str(tables))
        report.check(f"{what} the nodes of one", error < 1e-8,
                     f"{error:.2e} of the size")


def restart(report, folder, plane=False):
    """A run that was stopped ends as the run without a stop, on one rank and on
    two; a viscous capsule with another viscosity inside and bending, and a
    stiff one."""
    more = {"plane": plane, "cells": 4, "writeInterval": 3,
            "writeFormat": "binary", "timePrecision": 10}
    viscous = {**more, "deltaT": 0.1*STEP, "material":
               f"bendingModulus {0.01*VISCOSITY}; "
               f"innerViscosity {3*VISCOSITY}; {VISCOUS}"}
    stiff = {**more, "deltaT": STEP, **STIFF}
    for n, sheet in ((1, viscous), (2, viscous), (1, stiff), (2, stiff)):
        name = f"{n}{'stiff' if sheet is stiff else ''}"
        step = sheet["deltaT"]
        whole = capsule(folder, f"whole{name}", endTime=6*step, **sheet)
        stopped = capsule(folder, f"stopped{name}", endTime=3*step, **sheet)
        for case in (whole, stopped):
            if n > 1:
                case.decompose(n, 1, 1)
            case.run("fsiPisoFoam", ranks=n)
        stopped.control(startFrom="latestTime", endTime=6*step)
        stopped.run("fsiPisoFoam", ranks=n)
        rank = "processor0" if n > 1 else ""
        files = [os.path.join(rank, results.times(
            os.path.join(whole.path, rank))[-1], name)
            for name in ("U", "p", "phi", "uniform/fsiObjects/capsule")]
        differ = [f for f in files if not filecmp.cmp(
            os.path.join(whole.path, f), os.path.join(stopped.path, f), False)]
        report.check(f"restart on {name}: the same to the last bit",
                     not differ, str(differ))
