#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc settles in a channel; the frame goes along with it.

    movingFrame.py FOLDER

Its speed and way are those of the same disc in a frame at rest; ranks and
a restart change nothing.
"""

import os
import sys

import fsiCase
import results

DISC = ("disc { shape { type circle; radius 0.125; } "
        "material { type rigid; density 1.5; } }")

FRAME = "frame { follow 0; direction (0 -2 0); }\n"

FLOW = {"bottom": ("type fixedValue; value uniform (0 0 0);",
                   "type zeroGradient;"),
        "top": ("type zeroGradient;", "type fixedValue; value uniform 0;")}


def channel(folder, name, moves, **parameters):
    """A channel of the width 1, seeded. moves: does the frame?"""
    options = {
        "box": (0, 0, 1, 3), "cells": (32, 96), "viscosity": 0.01,
        "gravity": "(0 -1 0)", "shapes": DISC, "placements":
        "disc { type listed; shape disc; objects ({ centre (0.45 1.5 0); }); }",
        "deltaT": 0.04, "endTime": 4, "writePrecision": 17,
        "writeInterval": 25, "startFrom": "latestTime",
        "p_tolerance": 1e-10, "U_tolerance": 1e-11,
        "properties": FRAME if moves else "", "open": FLOW if moves else {},
        **parameters,
    }
    return fsiCase.Case(os.path.join(folder, name), **options).set_up()


def fall(case, moves):
    """Speed and way of the disc at the end, in a frame at rest."""
    last = results.table(case.path, "objects.csv")[-1]
    speed, place = last["velocityY"], last["centroidY"]
    if moves:
        frame = results.table(case.path, "frame.csv")[-1]
        speed += frame["velocityY"]
        place += frame["positionY"]
    return speed, place - 1.5


def check_fall(report, folder, scheme):
    """Against a frame at rest; where the disc is in the frame."""
    fell = {}
    for moves in (False, True):
        case = channel(folder, f"{scheme}{moves}", moves, time_scheme=scheme)
        if report.attempt(f"{scheme}, frame moves: {moves}", case.run,
                          "fsiPisoFoam") is None:
            return None
        fell[moves] = fall(case, moves)
    print(f"    {scheme}: speed and way {fell[False]}, {fell[True]}")
    for what, one, other in zip(("speed", "way"), *fell.values()):
        report.check(f"{scheme}: {what} of the disc", abs(other/one - 1) < 0.01,
                     f"{other} in place of {one}")
    stays = results.table(case.path, "objects.csv")[-1]["centroidY"] - 1.5
    report.check(f"{scheme}: the disc stays in the frame", abs(stays) < 0.02,
                 stays)
    return case


def check_restart(report, folder, whole, scheme):
    """Two runs, one after the other, give what one gives to the last bit."""
    parts = channel(folder, f"{scheme}Parts", True, time_scheme=scheme)
    for end in (2, 4):
        parts.control(endTime=end)
        report.attempt(f"{scheme} to {end}", parts.run, "fsiPisoFoam")
    for name in ("U", "p", "uniform/fsiFrame", "uniform/fsiObjects/disc"):
        one, other = (results.read(case.path, "4", name)
                      for case in (whole, parts))
        report.check(f"{scheme}: a restart changes no bit of {name}",
                     one == other, "it does")


def check_ranks(report, folder, whole):
    """Two ranks give what one gives."""
    case = channel(folder, "ranks", True)
    case.decompose(1, 2)
    report.attempt("2 ranks", case.run, "fsiPisoFoam", ranks=2)
    case.run("reconstructPar")
    one, other = (fall(c, True) for c in (whole, case))
    report.check("2 ranks change nothing", max(
        abs(a - b) for a, b in zip(one, other)) < 1e-8, (one, other))


def check_refused(report, folder):
    """What cannot move with a frame is named."""
    for name, walls, texts in (
            ("noSlip", {"left": ("type noSlip;", "type zeroGradient;")},
             ("left", "noSlip", "fixedValue")),
            ("a wall across", {"top": None}, ("top", "direction"))):
        flow = {k: v for k, v in {**FLOW, **walls}.items() if v}
        case = channel(folder, "refused", True, open=flow, walls={})
        try:
            case.run("fsiPisoFoam")
            error = "it runs"
        except RuntimeError:
            error = results.read(case.path, "log.fsiPisoFoam")
        report.check(f"{name} is refused by name",
                     all(text in error for text in texts), error[-600:])


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for scheme in ("Euler", "backward"):
        case = check_fall(report, folder, scheme)
        if case is not None:
            check_restart(report, folder, case, scheme)
            if scheme == "Euler":
                check_ranks(report, folder, case)
    check_refused(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
