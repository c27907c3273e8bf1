# SPDX-License-Identifier: GPL-3.0-or-later
"""Capsules and a body fall onto a capsule whose faces are four cells long."""

import os
import re

import fsiCase
import results

VISCOSITY = 20
STEP = 0.02


MATERIAL = ("material {{ type membrane; law neoHookean; shearModulus "
            f"{VISCOSITY/0.3}; density {{}}; }}}}")


def falling(path, plane, body, gap):
    """A membrane, or a rigid body that is pointed below, on a capsule."""
    dims = 2 if plane else 3
    ball = f"shape {{ type {'circle' if plane else 'sphere'}; radius "
    if body:
        kind, axes = (("ellipse", "0.2 0.6") if plane
                      else ("ellipsoid", "0.2 0.6 0.2"))
        upper = (f"shape {{ type {kind}; semiAxes ({axes}); }} "
                 "material { type rigid; density 400; }")
    else:
        upper = ball + "0.5; } " + MATERIAL.format(60)
    return fsiCase.Case(
        path, box=(-2,)*dims + (2,)*dims, cells=(32,)*dims,
        viscosity=VISCOSITY, cyclic="x" if plane else "xz",
        gravity="(0 -10 0)", deltaT=STEP, endTime=30*STEP, writeInterval=5,
        writePrecision=17, p_tolerance=1e-12, U_tolerance=1e-12,
        properties=f"membranes {{ {gap} }} output {{ objectsEvery 1; }} "
                   "contact { law { type none; } }",
        shapes=f"lower {{ {ball} 1; }} nodeSpacing 0.5; "
               f"{MATERIAL.format(1)} }} upper {{ {upper} }}",
        placements="a { type listed; shape lower; objects ({ centre "
                   "(0 -0.9 0); }); } b { type listed; shape upper; objects "
                   f"({{ centre (0.1 {0.75 if body else 0.65} 0.05); }}); }}"
    ).set_up()


def inside(case):
    """Nodes inside other objects, at each written time."""
    counts = re.findall(r"inside other objects: (\d+) of \d+"
                        r"(?:, .* inside membranes: (\d+))?",
                        case.run("fsiPisoFoam"))
    return [int(a) + int(b or 0) for a, b in counts]


def check_falling(report, folder, plane, body):
    """With the limit no node gets through, and ranks agree."""
    name = "body" if body else "membrane"
    path = os.path.join(folder, name)
    free = inside(falling(path + "Through", plane, body, "minimumGap 0;"))
    case = falling(path, plane, body, "")
    kept = inside(case)
    report.check(f"{name}: nodes get through long faces without the limit",
                 max(free) > 0, str(free))
    report.check(f"{name}: no node gets through with it", len(kept) > 4
                 and max(kept) == 0, str(kept))
    rows = results.table(case.path, "objects.csv")
    size = "area" if plane else "volume"
    change = max(abs(last[size]/first[size] - 1)
                 for first, last in zip(rows[:2], rows[-2:]))
    report.check(f"{name}: volumes are kept", change < 1e-6, f"{change:.1e}")
    other = falling(path + "Ranks", plane, body, "")
    other.decompose(1, 2, 1)
    other.run("fsiPisoFoam", ranks=2)
    other.run("reconstructPar", "-latestTime")
    error = results.difference(case.path, other.path)
    report.check(f"{name}: the same on two ranks", error < 1e-8,
                 f"{error:.2e}")


def check(report, folder, plane=False):
    """No node gets through a long face."""
    for body in (False, True):
        check_falling(report, folder, plane, body)
