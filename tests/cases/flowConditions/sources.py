#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's own fvOptions act in fsiPisoFoam: porosity takes the pressure that
Darcy's law says, an acceleration is felt, a mean velocity is kept, and speeds
are limited.

    sources.py FOLDER
"""

import sys

import fsiCase
import results
from openChannel import CELLS, PLUG, channel

VISCOSITY = 0.01

BOX = """actions ({ name zone; type cellZoneSet; action new;
    source boxToCell; sourceInfo { box (0.5 -1 -1) (1 2 1); } });
"""
ALL = "selectionMode all;"
ZONE = "selectionMode cellZone; cellZone zone;"

POROSITY = f"""porosity
{{
    type explicitPorositySource;
    explicitPorositySourceCoeffs
    {{
        {ZONE}
        type DarcyForchheimer;
        DarcyForchheimerCoeffs
        {{
            d (100 100 100);
            f (0 0 0);
            coordinateSystem {{ type cartesian; origin (0 0 0);
                rotation {{ type none; }} }}
        }}
    }}
}}
"""


def option(kind, entries):
    """An option of a type for the whole mesh."""
    return f"a {{ type {kind}; {kind}Coeffs {{ {ALL} {entries} }} }}\n"


def solve(folder, name, options, steps, **parameters):
    """A channel with a disc and options; the case."""
    case = channel(folder, name, ((1.5, 0.5, 0),), viscosity=VISCOSITY,
                   endTime=0.01*steps, writeInterval=steps, **parameters)
    case.file("system/topoSetDict", BOX)
    case.run("topoSet")
    case.file("constant/fvOptions", options)
    case.run("fsiPisoFoam")
    return case.path


def along_x(case, time):
    """Velocities along x of all cells."""
    return results.numbers(results.read(case, time, "U"),
                           "internalField")[::3]


def check_porosity(report, folder):
    """nu d U over the length of the zone, with a plug flow."""
    case = report.attempt("porosity", solve, folder, "porosity", POROSITY, 40,
                          walls=PLUG)
    if case is None:
        return
    p = results.numbers(results.read(case, "0.4", "p"), "internalField")
    row = CELLS[0]*(CELLS[1]//2)
    drop = p[row + 2] - p[row + 26]
    report.check("porosity: the drop of pressure is Darcy's",
                 abs(drop/(VISCOSITY*100*0.5) - 1) < 0.02, drop)


def check_drives(report, folder):
    """In a periodic box from rest, at first without friction."""
    rest = {"open": {}, "cyclic": "x", "velocity": "(0 0 0)"}
    for kind, entries, expected in (
            ("vectorSemiImplicitSource", "volumeMode specific; "
             "injectionRateSuSp { U ((2 0 0) 0); }", 0.06),
            ("meanVelocityForce", "fields (U); Ubar (0.5 0 0);", 0.5)):
        case = report.attempt(kind, solve, folder, kind,
                              option(kind, entries), 3, **rest)
        if case is None:
            continue
        middle = along_x(case, "0.03")[CELLS[0]*(CELLS[1]//2) + 5]
        report.check(f"{kind} drives the fluid",
                     abs(middle/expected - 1) < 0.2, middle)


def check_limits(report, folder):
    """Options that limit a velocity: at the inlet it is 1."""
    for kind, entries, largest in (
            ("limitVelocity", "max 0.5;", 0.8),
            ("velocityDampingConstraint", "UMax 0.5;", 0.999)):
        case = report.attempt(kind, solve, folder, kind,
                              option(kind, entries), 3)
        if case is not None:
            speed = along_x(case, "0.03")[5]
            report.check(f"{kind} acts", speed < largest, speed)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_porosity(report, folder)
    check_drives(report, folder)
    check_limits(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
