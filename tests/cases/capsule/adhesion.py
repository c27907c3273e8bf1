# SPDX-License-Identifier: GPL-3.0-or-later
"""Two capsules that attract each other."""

import os

import fsiCase
import results

VISCOSITY = 20
STEP = 0.02


def check(report, folder):
    """Two capsules at 1.5 cells come together, and ranks agree."""
    def pair(name, energy, **more):
        values = {"deltaT": STEP, "endTime": 10*STEP, "writeInterval": 10,
                  "writePrecision": 17, "p_tolerance": 1e-12,
                  "U_tolerance": 1e-12, **more}
        return fsiCase.Case(
            os.path.join(folder, name), box=(-3, -2, -2, 3, 2, 2),
            cells=(24, 16, 16), viscosity=VISCOSITY, cyclic="xz",
            properties="output { objectsEvery 1; } membranes { contact { "
                       f"law {{ type Morse; adhesionEnergy {energy}; "
                       "equilibriumGap 0.5; width 0.5; } } }",
            shapes="capsule { shape { type sphere; radius 1; } material { type "
                   "membrane; law neoHookean; density 1; shearModulus "
                   f"{VISCOSITY/0.3}; }} }}",
            placements="a { type listed; shape capsule; objects ({ centre "
                       "(-1.17 0 0); } { centre (1.17 0 0); }); }",
            **values).set_up()

    case = pair("adhesion", 10)
    case.run("fsiPisoFoam")
    a, b = results.table(case.path, "objects.csv")[-2:]
    gap = b["centroidX"] - a["centroidX"]
    report.check("capsules attract each other", gap < 2.3398
                 and abs(a["centroidX"] + b["centroidX"]) < 1e-4, str(gap))
    other = pair("adhesionRanks", 10)
    other.decompose(2, 1, 1)
    other.run("fsiPisoFoam", ranks=2)
    other.run("reconstructPar", "-latestTime")
    error = results.difference(case.path, other.path)
    report.check("adhesion on two ranks", error < 1e-8, f"{error:.2e}")
    try:
        text = pair("strong", 1e5).run("fsiPisoFoam")
    except RuntimeError as fault:
        text = str(fault)
    report.check("too strong an adhesion is refused",
                 "too long for the forces between membranes" in text, text)
