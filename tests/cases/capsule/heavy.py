# SPDX-License-Identifier: GPL-3.0-or-later
"""The weight of the fluid inside a membrane does not depend on where the box
is: a heavy capsule falls far from the origin as it does near it."""

import os

import fsiCase
import results

SHAPE = """ball
{
    shape { type sphere; radius 0.25; }
    material { type membrane; density 1.2; law neoHookean; shearModulus 1; }
}
"""


def fall(folder, shift):
    """The last lines of both tables; the box is moved up."""
    case = fsiCase.Case(
        os.path.join(folder, f"heavy{shift}"), viscosity=0.1,
        box=(0, shift, 0, 1, shift + 1, 1), cells=(16, 16, 16),
        gravity="(0 -1 0)", shapes=SHAPE,
        placements="a { type listed; shape ball; objects ({ centre (0.5 "
                   f"{shift + 0.5} 0.5); }}); }}",
        deltaT=2e-3, endTime=0.02, writeInterval=10).set_up()
    case.run("fsiPisoFoam")
    return {**results.table(case.path, "objects.csv")[-1],
            **results.table(case.path, "global.csv")[-1]}


def check(report, folder):
    """Near the origin and far from it."""
    near, far = (fall(folder, shift) for shift in (0, 100))
    for name, tolerance in (("maxSpeed", 1e-4), ("velocityY", 1e-4),
                            ("stretch", 1e-6)):
        report.check(f"a heavy capsule far from the origin: {name}",
                     abs(far[name] - near[name])
                     <= tolerance*abs(near[name]),
                     f"{far[name]} for {near[name]}")
    report.check("a heavy capsule falls", near["velocityY"] < -1e-4,
                 f"{near['velocityY']}")
