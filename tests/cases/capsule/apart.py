# SPDX-License-Identifier: GPL-3.0-or-later
"""A capsule falls onto another one, whose faces are four cells long."""

import os
import re

import fsiCase
import results

VISCOSITY = 20
STEP = 0.02


def check(report, folder, plane=False):
    """No node gets through a long face, and ranks agree."""
    ball = "circle" if plane else "sphere"
    dims = 2 if plane else 3

    def falling(name, gap, **more):
        material = ("type membrane; law neoHookean; shearModulus "
                    f"{VISCOSITY/0.3}; density")
        values = {"deltaT": STEP, "endTime": 30*STEP,
                  "writeInterval": 5, "writePrecision": 17,
                  "p_tolerance": 1e-12, "U_tolerance": 1e-12, **more}
        return fsiCase.Case(
            os.path.join(folder, name), box=(-2,)*dims + (2,)*dims,
            cells=(32,)*dims, viscosity=VISCOSITY,
            cyclic="x" if plane else "xz",
            gravity="(0 -10 0)",
            properties=f"membranes {{ {gap} }} output {{ objectsEvery 1; }} "
                       "contact { law { type none; } }",
            shapes=f"lower {{ shape {{ type {ball}; radius 1; }} "
                   f"nodeSpacing 0.5; material {{ {material} 1; }} }} "
                   f"upper {{ shape {{ type {ball}; radius 0.5; }} "
                   f"material {{ {material} 60; }} }}",
            placements="a { type listed; shape lower; objects ({ centre "
                       "(0 -0.9 0); }); } b { type listed; shape upper; "
                       "objects ({ centre (0.1 0.65 0.05); }); }",
            **values).set_up()

    def run(name, gap):
        case = falling(name, gap)
        text = case.run("fsiPisoFoam")
        return case, [int(n) for n in re.findall(
            r"inside other objects: (\d+) of", text)]

    _, free = run("through", "minimumGap 0;")
    case, kept = run("apart", "")
    report.check("nodes get through long faces without the limit",
                 max(free) > 0, str(free))
    report.check("no node gets through with it", len(kept) > 4
                 and max(kept) == 0, str(kept))
    rows = results.table(case.path, "objects.csv")
    size = "area" if plane else "volume"
    change = max(abs(last[size]/first[size] - 1)
                 for first, last in zip(rows[:2], rows[-2:]))
    report.check("their volumes are kept", change < 1e-6, f"{change:.1e}")
    other = falling("apartRanks", "")
    other.decompose(1, 2, 1)
    other.run("fsiPisoFoam", ranks=2)
    other.run("reconstructPar", "-latestTime")
    error = results.difference(case.path, other.path)
    report.check("the same on two ranks", error < 1e-8, f"{error:.2e}")
