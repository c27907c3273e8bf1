#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of all kinds in a fluid whose viscosity depends on the shear rate:
ranks, a restart, the limit of a Newtonian fluid, the flow past a disc beside
OpenFOAM's own solver, and what is refused.

    bodies.py FOLDER
"""

import os
import sys

import anyRanks
import fsiCase
import refused
import results
import smallCase
from laws import entries

CARREAU = ("BirdCarreau", {"nu0": 0.1, "nuInf": 0.005, "k": 2, "n": 0.4})

# Superficial velocity at t = 12 from rest with the acceleration 1, through a
# periodic array of discs of radius 0.25 in squares of size 1, by pimpleFoam on
# four blocks around a disc. Thinning: 48 x 24 cells each (24 x 12: 0.8897).
# Carreau: 32 x 16 cells (24 x 12: 0.2492; with 48 x 24 it oscillates).
# Thickening: 24 x 12 cells
PAST_DISCS = {
    "thinning": (("powerLaw", {"k": 0.05, "n": 0.6, "nuMin": 1e-4,
                               "nuMax": 10}), 0.9019),
    "Carreau": (("BirdCarreau", {"nu0": 0.2, "nuInf": 0.01, "k": 2,
                                 "n": 0.4}), 0.2492),
    "thickening": (("powerLaw", {"k": 0.05, "n": 1.4, "nuMin": 1e-4,
                                 "nuMax": 10}), 0.2637),
}

SPHERES = """
sphere { shape { type sphere; radius 0.2; } material { density 1.1; E 100; } }
ball { shape { type sphere; radius 0.15; }
    material { density 1.2; type rigid; } }
cell { shape { type sphere; radius 0.18; } material { type membrane;
    law neoHookean; density 1; shearModulus 0.1; innerViscosity 0.1; } }
drop { shape { type sphere; radius 0.18; } material { type membrane;
    law neoHookean; density 1; shearModulus 0.1; } }
"""

AT = """
a { type listed; shape sphere; objects ({ centre (0.02 0.28 0.5); }); }
b { type listed; shape ball; objects ({ centre (0.5 0.23 0.52); }); }
c { type listed; shape cell; objects ({ centre (0.25 0.72 0.5); }); }
d { type listed; shape drop; objects ({ centre (0.75 0.7 0.45); }); }
"""


def with_law(build, law, **parameters):
    """A function that builds a case of this law."""
    def made(path, **more):
        case = build(path, **parameters, **more)
        case.file("constant/transportProperties", entries(*law))
        return case

    made.__name__ = build.__name__
    return made


def ranks(report, folder):
    """One, two and three ranks, of which one has no cells."""
    anyRanks.compare(report, folder, with_law(anyRanks.channel, CARREAU),
                     ((2, 1), "hollow"))
    anyRanks.compare(
        report, folder, with_law(anyRanks.box, CARREAU, shapes=SPHERES,
                                 placements=AT, cells=(20, 20, 20)),
        ((2, 1, 1), (1, 3, 1)))


def restart(report, folder):
    """A run in two parts writes what one in a single part does."""
    build = with_law(smallCase.small_case, CARREAU, writeInterval=10)
    whole, parts = (build(os.path.join(folder, name), endTime=end)
                    for name, end in (("whole", 0.1), ("parts", 0.05)))
    whole.run("fsiPisoFoam")
    parts.run("fsiPisoFoam")
    parts.control(endTime=0.1)
    parts.run("fsiPisoFoam")
    one, two = (smallCase.result(os.path.join(case.path, "0.1"))
                for case in (whole, parts))
    report.check("a restart to the last bit", one == two and "nu" in one,
                 [k for k in one if one[k] != two.get(k)])


def newtonian_limit(report, folder):
    """With nu0 = nuInf all is as in a Newtonian fluid; the same fluid inside
    the membrane, beside which the transposed part has another constant."""
    law = ("BirdCarreau", {"nu0": 0.01, "nuInf": 0.01, "k": 1, "n": 0.5})
    shapes = smallCase.SHAPES.replace("innerViscosity 0.1",
                                      "innerViscosity 0.01")
    cases = [
        build(os.path.join(folder, name), endTime=0.1, U_tolerance=1e-12,
              p_tolerance=1e-12, shapes=shapes)
        for name, build in (
            ("Newtonian", smallCase.small_case),
            ("limit", with_law(smallCase.small_case, law)))]
    for case in cases:
        case.control(writeInterval=20)
        case.run("fsiPisoFoam")
    error = results.difference(*(case.path for case in cases))
    report.check("the limit of a Newtonian fluid", error < 1e-8, error)


def past_discs(report, folder, name):
    """The flow that an acceleration drives through an array of discs."""
    law, reference = PAST_DISCS[name]
    n = 32
    case = fsiCase.Case(
        os.path.join(folder, "array" + name), cells=(n, n), cyclic="xy",
        deltaT=0.01, endTime=12, writeInterval=1200,
        properties="drivingForce { type acceleration; "
                   "acceleration (1 0 0); }\n",
        shapes="disc { shape { type circle; radius 0.25; } material "
               "{ type rigid; density 1; } motion { type fixed; } }",
        placements="discs { type listed; shape disc; "
                   "objects ({ centre (0.5013 0.4987 0); }); }")
    case.file("constant/transportProperties", entries(*law))
    case.set_up().run("fsiPisoFoam")
    mean = sum(results.field(case.path, "12", "U")[::3])/n**2
    print(f"    {name}, past discs: {mean:.4f}, pimpleFoam {reference}")
    report.check(f"{name}, flow past discs", abs(mean/reference - 1) < 0.025,
                 f"{mean}, not {reference}")


def refusals(report, folder):
    """What is for Newtonian fluids."""
    for name, properties, texts in (
            ("weak", fsiCase.THESIS + "coupling { type weak; }",
             ["BirdCarreau", "weak", "solidImplicit"]),
            ("rheology", "output { rheology yes; }",
             ["rheology", "Newtonian"])):
        case = with_law(smallCase.small_case, CARREAU)(
            os.path.join(folder, name), properties=properties, cyclic="x")
        refused.refused(report, f"{name} is refused", case, "fsiPisoFoam",
                        texts)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for part in (ranks, restart, newtonian_limit, refusals):
        report.attempt(part.__name__, part, report, folder)
    for name in PAST_DISCS:
        report.attempt(f"{name}, past discs", past_discs, report, folder, name)
    sys.exit(report.failures > 0)


if __name__ == "__main__":
    main(sys.argv[1])
