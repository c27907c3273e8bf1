#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres that leave a channel in three dimensions and are fed into it.

    feed.py FOLDER
"""

import os
import sys

import fsiCase
import results

RADIUS = 0.17

# Gaps are above the range of contact, 3 h: nothing disturbs the uniform flow
END = 0.8

OPEN = {
    "left": ("type fixedValue; value uniform (1 0 0);", "type zeroGradient;"),
    "right": ("type zeroGradient;", "type fixedValue; value uniform 0;"),
}

FEED = """boundaries { feed { left { shape sphere; velocity (1 0 0); rate 5;
    startTime 0.02; minimumGap 0.26; sideGap 0.26; seed 2; } } }
"""


def channel(folder):
    """Plug flow through a channel with a sphere near its end."""
    slip = {side: "(1 0 0)" for side in ("bottom", "top", "back", "front")}
    return fsiCase.Case(
        os.path.join(folder, "channel"), box=(0, 0, 0, 2, 1, 1),
        cells=(24, 12, 12), density=1000, open=OPEN, walls=slip,
        velocity="(1 0 0)", deltaT=0.01, endTime=END, writeInterval=10,
        properties=FEED,
        shapes=f"sphere {{ shape {{ type sphere; radius {RADIUS}; }} "
               "material { density 1000; E 1e5; } }",
        placements="a { type listed; shape sphere; velocity (1 0 0); "
                   "objects ({ centre (1.75 0.5 0.5); }); }").set_up()


def check(report, case):
    """What came, where, and what left."""
    log = case.run("fsiPisoFoam")
    rows = results.table(case.path, "objects.csv")
    last = results.table(case.path, "global.csv")[-1]
    fed = [r for r in rows if r["object"] > 0]
    first = {r["object"]: r for r in reversed(fed)}.values()
    report.check("the first sphere leaves", last["removed"] == 1
                 and not any(r["object"] == 0 for r in rows
                             if r["time"] > END - 1e-6),
                 f"{last['removed']} left")
    report.check("spheres come", last["fed"] >= 2 and len(first) >= 2,
                 f"{last['fed']} fed")
    away = [min(r[c], 1 - r[c]) for r in first
            for c in ("centroidY", "centroidZ")]
    report.check("they keep sideGap", min(away) > RADIUS + 0.26 - 1e-3,
                 f"{min(away)}")
    places = [(round(r["centroidY"], 3), round(r["centroidZ"], 3))
              for r in first]
    report.check("their places differ in y and z",
                 all(len(set(c)) == len(c) for c in zip(*places)), f"{places}")
    report.check("the feed waits where there is no room",
                 "waits for room" in log)
    text = case.run("checkObjects", "-maxSpeed", "1.1")
    report.check("objects are sound", "Objects are sound" in text, text[-300:])


def check_refused(report, case):
    """A sphere as wide as the channel."""
    case.file("constant/fsiProperties", "fluidDensity 1000;\n" + FEED.replace(
        "sideGap 0.26", "sideGap 0.4"))
    try:
        case.run("fsiPisoFoam")
        report.check("a feed too narrow is refused", False, "it is accepted")
    except RuntimeError as error:
        text = " ".join(str(error).split())
        report.check("a feed too narrow is refused",
                     "sideGap" in text and "never fits" in text, text)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = report.attempt("seeding", channel, folder)
    if case is not None:
        report.attempt("feeding", check, report, case)
        check_refused(report, case)


if __name__ == "__main__":
    main(sys.argv[1])
