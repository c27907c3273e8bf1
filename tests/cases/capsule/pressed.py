# SPDX-License-Identifier: GPL-3.0-or-later
"""Heavy capsules in two dimensions lie on the floor, on each other and under a
body, and leave through a side: they stay out of each other and in the domain,
and keep their area."""

import os
import re

import fsiCase
import results


def box(folder, name, shapes, places, **more):
    """A case in a box of size 1. shapes: (name, shape, material); places: of
    each, centres and what else."""
    return fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 1, 1), cells=(40, 40),
        viscosity=0.01, density=1000, gravity="(0 -9.81 0)",
        **{"properties": "output { crossing warn; }",
           "shapes": " ".join(f"{a} {{ {b} material {{ {c} }} }}"
                              for a, b, c in shapes),
           "placements": " ".join(
               f"{a} {{ type listed; shape {a}; objects ({b}); }}"
               for a, b in places.items()), **more}).set_up()


def capsule(radius, modulus, density=2500, spacing=""):
    """Shape and material of a capsule."""
    return ("m", f"{spacing} shape {{ type circle; radius {radius}; }}",
            f"type membrane; density {density}; shearModulus {modulus};")


def run(report, name, case):
    """Runs it: nodes inside others, objects outside, change of the area."""
    text = case.run("fsiPisoFoam")
    inside = [int(a) + int(b or 0) for a, b in re.findall(
        r"inside other objects: (\d+) of \d+"
        r"(?:, .* inside membranes: (\d+))?", text)]
    checked = case.run("checkObjects")
    outside = [int(n) for n in re.findall(r"(\d+) outside", checked)]
    change = max(row["areaChange"]
                 for row in results.table(case.path, "global.csv"))
    report.check(f"{name}: no node is inside another object",
                 len(inside) > 5 and max(inside) == 0, str(inside))
    report.check(f"{name}: none leaves through a wall",
                 len(outside) > 5 and max(outside) == 0, str(outside))
    return change


def check(report, folder):
    """All cases."""
    change = run(report, "floor", box(
        folder, "floor", [capsule(0.2, 20)], {"m": "{ centre (0.5 0.25 0); }"},
        deltaT=0.005, endTime=3, writeInterval=75))
    report.check("on the floor its area is kept", change < 1e-9,
                 f"{change:.1e}")
    run(report, "stack", box(
        folder, "stack", [capsule(0.16, 77, 1900, "nodeSpacing 0.05;")],
        {"m": "{ centre (0.5 0.2 0); } { centre (0.56 0.6 0); }"},
        deltaT=0.004, endTime=3, writeInterval=75))
    star = ("s", "shape { type star; radius 0.13; amplitude 0.3; points 4; }",
            "type rigid; density 3000;")
    run(report, "star", box(
        folder, "star", [capsule(0.2, 2, 1100), star],
        {"m": "{ centre (0.5 0.25 0); }",
         "s": "{ centre (0.52 0.7 0); rotation 45; }"},
        deltaT=0.002, endTime=0.7, writeInterval=50))
    change = run(report, "outlet", box(
        folder, "outlet", [capsule(0.15, 20)],
        {"m": "{ centre (0.6 0.2 0); }"}, deltaT=0.005, endTime=4,
        writeInterval=80,
        open={"left": ("type fixedValue; value uniform (0.2 0 0);",
                       "type zeroGradient;"),
              "right": ("type zeroGradient;",
                        "type fixedValue; value uniform 0;")}))
    report.check("at an outlet its area is kept", change < 1e-9,
                 f"{change:.1e}")
