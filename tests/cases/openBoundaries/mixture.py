# SPDX-License-Identifier: GPL-3.0-or-later
"""A feed of two shapes, three small discs for each large one."""

import re

import results
from openChannel import channel

SHAPES = ("disc { shape { type circle; radius 0.15; } material { density 1; "
          "E 100; } } dot { shape { type circle; radius 0.08; } material { "
          "density 1; E 100; } }")

FEED = ("boundaries { feed { left { shapes ((disc 1) (dot 3)); rate 6; "
        "velocity (1 0 0); seed 5; } } }\n")

ORDER = ["dot", "disc", "dot", "dot"]


def fed(case):
    """Shapes in the order in which they came in."""
    log = results.read(case.path, "log.fsiPisoFoam")
    return re.findall(r"Object \d+ of shape (\w+) fed at left", log)


def check(report, folder):
    """The parts hold from the first objects on, and after a restart."""
    runs = {}
    for name, ends in (("mixture", (1.2,)), ("mixtureParts", (0.6, 1.2))):
        case = report.attempt(
            f"{name}, set-up", channel, folder, name, (), shapes=SHAPES,
            placements="", writeInterval=60, writePrecision=17,
            properties=FEED)
        shapes = []
        for end in ends if case else ():
            case.control(startFrom="latestTime", endTime=end)
            if report.attempt(f"{name}, to {end}", case.run, "fsiPisoFoam"):
                shapes += fed(case)
        report.check(f"{name}: three small discs for a large one",
                     len(shapes) > 6
                     and shapes == (ORDER*4)[:len(shapes)], shapes)
        runs[name] = case
    if all(runs.values()):
        one, other = (results.state(case.path, "1.2")
                      for case in runs.values())
        report.check("a restart feeds the same mixture", one == other,
                     f"objects {list(one)} and {list(other)}")
