# SPDX-License-Identifier: GPL-3.0-or-later
"""Membranes in three dimensions at open sides."""

import os

import fsiCase
import results

STEP = 0.02

# dt nu/h^2 is 26
VISCOSITY = 20

PRESSURE = ("type zeroGradient;", "type fixedValue; value uniform 0;")


def channel(folder, name, inlet=True, walls=0, feed="", **more):
    """A sphere of radius 0.5, a neo-Hookean membrane, in a channel of four by
    two by two with an inlet on the left, or with p on both sides."""
    left = ("type fixedValue; value uniform (1 0 0);", "type zeroGradient;")
    speed = int(inlet)
    case = fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 0, 4, 2, 2), cells=(32, 16, 16),
        viscosity=VISCOSITY, velocity=f"({speed} 0 0)",
        open={"left": left if inlet else PRESSURE, "right": PRESSURE},
        walls={side: f"({walls} 0 0)"
               for side in ("bottom", "top", "back", "front")},
        properties="output { objectsEvery 1; } boundaries { feed { "
                   + feed + " } }",
        shapes="cell { shape { type sphere; radius 0.5; } material { type "
               "membrane; law neoHookean; shearModulus 60; density 1; } }",
        placements="a { type listed; shape cell; wallGap 0; objects "
                   "({ centre (2.4 1 1); }); }",
        **{"deltaT": STEP, "writeInterval": 25, "p_tolerance": 1e-6,
           "U_tolerance": 1e-7, **more})
    return case.set_up()


def check_rest(report, folder):
    """Beside a patch that gives the pressure a membrane stays at rest, and in
    a uniform flow it leaves as it came. Where differences of the pressure do
    not fade at the patch they grow, by 40 in a step."""
    for name, speed in (("still", 0), ("uniform", 1)):
        case = channel(folder, name, speed, speed, endTime=3)
        case.run("fsiPisoFoam")
        rows = results.table(case.path, "objects.csv")
        off = max(abs(row["velocityX"] - speed) for row in rows)
        wide = max(row["stretch"] for row in rows) - 1
        report.check(f"{name} flow: nothing moves or stretches a membrane",
                     off < 1e-6 and wide < 1e-6, f"{off}, {wide}")
        last = results.table(case.path, "global.csv")[-1]
        report.check(f"{name} flow: it leaves or stays",
                     (last["objects"], last["removed"]) == (1 - speed, speed),
                     str(last))


FEED = ("left { shape cell; velocity (1 0 0); rate 1.1; sideGap 0.2; "
        "minimumGap 0.2; }")


def check_middle(report, rows):
    """The first membrane that came in, at x = 2.4: the flow has made a drop of
    it. With 12 in place of 8 cells to the radius its half axes are 0.644,
    0.492 and 0.404, and it moves at 1.694."""
    row = min(rows, key=lambda row: abs(row["centroidX"] - 2.4))
    for name, fine in (("halfAxisA", 0.644), ("halfAxisB", 0.492),
                       ("halfAxisC", 0.404), ("velocityX", 1.694)):
        report.check(f"membranes go with the flow: {name}",
                     abs(row[name]/fine - 1) < 0.02, f"{row[name]}, {fine}")


def check_through(report, folder):
    """Membranes come in and leave between walls at rest. Outside they keep
    their shapes, inside the flow stretches them."""
    case = channel(folder, "fed", feed=FEED, endTime=2.8)
    text = case.run("fsiPisoFoam")
    rows = results.table(case.path, "objects.csv")
    coming = [row for row in rows if row["centroidX"] < 0.4]
    leaving = [row for row in rows if row["centroidX"] > 3.9]
    report.check("membranes come in as they are", len(coming) > 50 and max(
        abs(row["velocityX"] - 1) + row["stretch"] - 1 for row in coming)
                 < 1e-6, f"{coming[-1:]}")
    report.check("membranes leave as they are", len(leaving) > 10 and max(
        abs(row["stretch"] - leaving[0]["stretch"]) for row in leaving
        if row["object"] == leaving[0]["object"]) < 1e-6, f"{leaving[-1:]}")
    check_middle(report, [row for row in rows if row["object"] == 1])
    last = results.table(case.path, "global.csv")[-1]
    report.check("membranes are fed and leave", last["removed"] >= 1
                 and last["fed"] >= 2 and "left through" in text, str(last))
    report.check("membranes at open sides are sound", "Objects are sound"
                 in case.run("checkObjects"), "checkObjects")


def check_same(report, folder):
    """Two ranks, and a run that stops between."""
    short = {"feed": FEED, "writePrecision": 17, "p_tolerance": 1e-12,
             "U_tolerance": 1e-12}
    end = 50*STEP
    whole = channel(folder, "whole", endTime=end, **short)
    whole.run("fsiPisoFoam")
    parts = channel(folder, "parts", endTime=end/2, **short)
    parts.run("fsiPisoFoam")
    parts.control(startFrom="latestTime", endTime=end)
    parts.run("fsiPisoFoam")
    apart = results.difference(whole.path, parts.path)
    report.check("membranes at open sides: restart", apart == 0, f"{apart}")
    ranks = channel(folder, "ranks", endTime=end, **short)
    ranks.run("fsiPisoFoam", ranks=ranks.decompose(2, 1, 1))
    apart = results.difference(whole.path, ranks.path, ("", "processor0"))
    report.check("membranes at open sides: two ranks", apart < 1e-7,
                 f"{apart}")


def check(report, folder):
    """All of it."""
    report.attempt("membranes at rest", check_rest, report, folder)
    report.attempt("membranes pass", check_through, report, folder)
    report.attempt("membranes on ranks", check_same, report, folder)
