#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects leave through an outflow and are fed at an inflow.

    through.py FOLDER
"""

import os
import re
import sys

import fsiCase
import membranes
import mixture
import results
from openChannel import CELLS, OPEN, PLUG, SPEED, channel


def solve(*args, **parameters):
    """Makes and runs a channel; the case folder."""
    case = channel(*args, **parameters)
    case.run("fsiPisoFoam")
    return case.path


def field(case, time, name):
    """Values of a scalar field, and the first components of a vector field."""
    text = results.read(case, time, name)
    uniform = re.search(r"internalField\s+uniform (\S+);", text)
    if uniform:
        return [float(uniform.group(1))]*CELLS[0]*CELLS[1]
    values = results.numbers(text, "internalField")
    return values[::3] if "volVectorField" in text else values


FEED = ("boundaries {{ feed {{ left {{ shape disc; velocity (1 0 0); seed 5; "
        "{} }} }} }}\n")

# Where no patch gives the pressure: all velocities are given, or the outflow
# is what goes in
GIVEN = {"given": OPEN["left"],
         "adjusted": ("type zeroGradient;", "type zeroGradient;")}


def check_uniform(report, folder):
    """A disc that moves with a uniform flow leaves without any trace."""
    for name, right in {"uniform": OPEN["right"], **GIVEN}.items():
        case = report.attempt(
            f"{name} flow", solve, folder, name, ((1.5, 0.47, SPEED),),
            walls=PLUG, writeInterval=5, open={**OPEN, "right": right})
        if case is None:
            continue
        times = [t for t in results.times(case) if float(t) > 0]
        p = max(abs(v) for t in times for v in field(case, t, "p"))
        u = max(abs(v - SPEED) for t in times for v in field(case, t, "U"))
        print(f"    {name}: pressure {p:.1e}, velocity {u:.1e} off")
        # Of the dynamic pressure 1/2 and of the speed
        report.check(f"{name} flow: no pressure", p < 1e-6, f"{p:.2e}")
        report.check(f"{name} flow: no change of velocity", u < 1e-6,
                     f"{u:.2e}")
        last = results.table(case, "global.csv")[-1]
        report.check(f"{name} flow: the disc is removed and counted",
                     (last["objects"], last["removed"]) == (0, 1), last)
        log = results.read(case, "log.fsiPisoFoam")
        report.check(f"{name} flow: the log tells that it left",
                     "left through" in log, "no")
        rows = results.table(case, "removed.csv")
        off = [abs(row["centroidX"] - 1.5 - SPEED*row["time"])
               + abs(row["centroidY"] - 0.47)
               + abs(row["velocityX"] - SPEED) for row in rows]
        report.check(f"{name} flow: a table has where and when it left",
                     len(rows) == 1 and off[0] < 1e-6
                     and (rows[0]["object"], rows[0]["shape"],
                          rows[0]["patch"]) == (0, "disc", "right"), rows)


def check_inlets(report, folder):
    """Where no patch gives the pressure discs come in as fast as the fluid; a
    fixed disc lets nothing through the half of an inlet that it covers."""
    for name, right in GIVEN.items():
        case = report.attempt(
            f"inlet, {name}", solve, folder, "inlet" + name, (), walls=PLUG,
            open={**OPEN, "right": right}, endTime=0.5, properties=FEED.format(
                "rate 4;") + "output { objectsEvery 1; }\n")
        if case is not None:
            speeds = [r["velocityX"]
                      for r in results.table(case, "objects.csv")]
            report.check(f"discs come in with the flow, {name}",
                         len(speeds) > 40 and max(
                             abs(u - SPEED) for u in speeds) < 1e-6,
                         f"{min(speeds)} to {max(speeds)}")
    for name, right in {"fixed": OPEN["right"],
                        "adjusted": GIVEN["adjusted"]}.items():
        case = report.attempt(
            f"covered inlet, {name}", solve, folder, "covered" + name,
            ((0, 0.5, 0),), endTime=0.05, writeInterval=5,
            open={**OPEN, "right": right}, shapes="disc { shape { type circle; "
            "radius 0.25; } material { type rigid; density 1; } motion { type "
            "fixed; } }", placements="a { type listed; shape disc; minimumGap "
            "0; wallGap 0; objects ({ centre (0 0.5 0); }); }")
        if case is not None:
            out = field(case, "0.05", "U")[CELLS[0] - 1::CELLS[0]]
            report.check(f"a fixed disc closes its part of an inlet, {name}",
                         abs(sum(out)/len(out)/SPEED - 0.5) < 0.01,
                         f"{sum(out)/len(out)}")


def check_pressure(report, folder):
    """A heavy slow disc is pushed out: pressure from step to step."""
    steps = 160
    case = report.attempt(
        "heavy disc", solve, folder, "heavy", ((1.5, 0.47, 0.3),), density=3,
        endTime=0.01*steps, writeInterval=1)
    if case is None:
        return
    changes = pressure_changes(case)
    removed = [int(r["removed"]) for r in results.table(case, "global.csv")]
    if 1 not in removed:
        report.check("the heavy disc leaves", False, "it does not")
        return

    # The step of removal, and those in which the disc sticks out; before, from
    # the tenth step on, after the start
    step = removed.index(1)
    reaches = [max(x for x, _ in polygon) for polygon in
               (results.outlines(case, t)[0]
                for t in results.times(case)[1:step + 1])]
    first = next(i for i, x in enumerate(reaches) if x > 2)
    inside, leaving = max(changes[10:first]), max(changes[first:step])
    print(f"    largest change of p in a step, of the dynamic pressure: "
          f"{2*inside:.3f} inside, {2*leaving:.3f} while it leaves, "
          f"{2*changes[step]:.1e} at removal")
    report.check("no pressure spike at removal", changes[step] < 0.01*0.5,
                 f"{changes[step]:.2e}")
    report.check("no pressure spike while it leaves", leaving < inside,
                 f"{leaving:.2e} against {inside:.2e} inside")


def pressure_changes(case):
    """Largest change of p in each step, of the cells in the fluid before and
    after it; the first step has none."""
    changes, before = [0], None
    for time in results.times(case)[1:]:
        after = [p if phi > 0 else None for p, phi in zip(
            field(case, time, "p"), field(case, time, "signedDistance"))]
        if before:
            changes.append(max(abs(q - p) for p, q in zip(before, after)
                               if p is not None and q is not None))
        before = after
    return changes


def check_sound(report, case):
    """No overlap, nothing lost or beyond a wall at any time."""
    try:
        fsiCase.run(case, "checkObjects")
        report.check("the objects are sound", True)
    except RuntimeError as error:
        report.check("the objects are sound", False, str(error))


def check_feed(report, folder):
    """Discs are fed at a rate; a restart goes on as the run would."""
    runs = {}
    for name, ends in (("whole", (1.2,)), ("parts", (0.6, 1.2))):
        case = report.attempt(
            f"feed, {name}, set-up", channel, folder, name,
            ((0.5, 0.5, 1),), writeInterval=60, writePrecision=17,
            properties=FEED.format("rate 2.5; velocityPerturbation 0.05;"))
        if case is None:
            return
        for end in ends:
            case.control(startFrom="latestTime", endTime=end)
            if report.attempt(f"feed, {name}, to {end}", case.run,
                              "fsiPisoFoam") is None:
                return
        runs[name] = case.path
    rows = results.table(runs["whole"], "global.csv")
    last = rows[-1]
    report.check("a disc is fed every 0.4 s", last["fed"] == 3, last["fed"])
    report.check("no object is lost",
                 all(r["objects"] == 1 + r["fed"] - r["removed"]
                     for r in rows), "the numbers do not add up")
    check_sound(report, runs["whole"])
    check_sound(report, runs["parts"])
    one, other = (results.state(runs[name], "1.2") for name in runs)
    report.check("a restart feeds the same", one == other,
                 f"objects {list(one)} and {list(other)}, or their places")


def check_long(report, folder):
    """Soft discs cross the inlet of a long channel at its speed, and the fluid
    of the whole channel is no mass of theirs."""
    case = report.attempt(
        "feed into a long channel", solve, folder, "long", (),
        box=(0, 0, 4, 1), cells=(128, 32), velocity="(0.5 0 0)", density=1000,
        viscosity=0.01,
        open={**OPEN, "left": (OPEN["left"][0].replace("(1 ", "(0.5 "),
                               OPEN["left"][1])},
        shapes="disc { shape { type circle; radius 0.1; } "
               "material { density 1100; E 1e4; } }",
        placements="", endTime=0.7, p_tolerance=1e-7, U_tolerance=1e-8,
        properties="output { objectsEvery 1; } boundaries { feed { left { "
                   "shape disc; rate 3; velocity (0.5 0 0); } } }\n")
    if case is None:
        return
    speeds = [r["velocityX"] for r in results.table(case, "objects.csv")]
    report.check("discs cross the inlet of a long channel at its speed",
                 len(speeds) > 50 and 0.45 < min(speeds) <= max(speeds) < 0.55,
                 f"{len(speeds)} from {min(speeds)} to {max(speeds)} m/s")


def check_crowd(report, folder):
    """A feed that is faster than there is room waits."""
    case = report.attempt(
        "crowd", solve, folder, "crowd", ((0.5, 0.5, 1),), endTime=1.2,
        writeInterval=20, properties=FEED.format("rate 1000;"))
    if case is None:
        return
    log = results.read(case, "log.fsiPisoFoam")
    report.check("the log tells that the feed waits",
                 "waits for room" in log, "it does not")
    rows = results.table(case, "global.csv")
    report.check("fewer are fed than were asked for, and some",
                 4 < rows[-1]["fed"] < 100, rows[-1]["fed"])
    report.check("no object is lost in the crowd",
                 all(r["objects"] == 1 + r["fed"] - r["removed"]
                     for r in rows), "the numbers do not add up")
    check_sound(report, case)

    case = report.attempt(
        "target", solve, folder, "target", ((0.5, 0.5, 1),), endTime=1.5,
        properties=FEED.format("areaFraction 0.12;"))
    if case is None:
        return
    n = [r["objects"] for r in results.table(case, "global.csv")]
    target = 0.12*2/(3.1416*0.15**2)
    report.check("a target of area is kept", abs(max(n) - target) <= 0.75,
                 f"{max(n)} objects, target {target:.2f}")


def check_names(report, folder):
    """A patch feeds under any name that a word may be, and its counters go
    on at a restart."""
    for number, name in enumerate(("in-let.1", "in(2)[a]", "in.*+?")):
        case = channel(folder, f"name{number}", ((1.5, 0.5, 1),), endTime=0.02,
                       writeInterval=2, startFrom="latestTime",
                       properties=FEED.format("rate 2.5;").replace(
                           "left", name))
        for file in ("constant/polyMesh/boundary", "0/U", "0/p"):
            with open(os.path.join(case.path, file), encoding="ascii") as text:
                words = text.read().replace("left", name)
            with open(os.path.join(case.path, file), "w",
                      encoding="ascii") as text:
                text.write(words)
        fed = []
        for end in (0.02, 0.04):
            case.control(endTime=end)
            if report.attempt(f"patch {name}, to {end}", case.run,
                              "fsiPisoFoam") is None:
                return
            fed.append(results.table(case.path, "global.csv")[-1]["fed"])
        report.check(f"patch {name} feeds once", fed == [1, 1], fed)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_uniform(report, folder)
    check_inlets(report, folder)
    check_pressure(report, folder)
    check_feed(report, folder)
    check_long(report, folder)
    check_crowd(report, folder)
    check_names(report, folder)
    membranes.check(report, folder)
    mixture.check(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
