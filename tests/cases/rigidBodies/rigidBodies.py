#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid bodies in the fluid.

    rigidBodies.py FOLDER

1. A rigid disc in a driven cavity follows the path of a stiff elastic one, and
   turns as it does: their outlines are the same, and what the stiff one
   deforms is 1e-6. Two things differ: the stiff one's masses are those of its
   nodes, which makes its moment of inertia larger by some (h/R)^2/3, half a
   percent, and its pressure load is a mean over four steps.
2. A rigid body of a tenth of the fluid's density, and one that is not convex,
   come to rest when they were pushed: without a driving force the energy can
   only fall.
3. A rigid body keeps its area and its perimeter to the digits of the table.
4. It goes on bit by bit after a restart.
5. Bodies on which their weight less their buoyancy acts as a given force go as
   under gravity, and a given torque turns a body as its inertia lets it.
6. A disc on a wall under gravity that is tilted by 45 degrees, in next to no
   fluid, slides down by Coulomb's friction, or rolls; on three ranks as on one.
"""

import math
import os
import sys

import fsiCase
import results

STEPS = 100
THICKNESS = 1/30
OUTPUT = 10
DISC = "shape { type circle; radius 0.2; }"
CIRCLE = "shape { type circle; radius 0.12; }"
STAR = "shape { type star; radius 0.12; amplitude 0.3; points 5; }"


def cavity(folder, name, material, **changes):
    """Runs a disc in a driven cavity."""
    controls = {"deltaT": 0.01, "endTime": 0.01*STEPS,
                "writeInterval": OUTPUT, "writeFormat": "binary"}
    controls.update(changes)
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(40, 40), viscosity=0.01,
        walls={"top": "(1 0 0)"},
        shapes=f"disc {{ {DISC} material {{ {material} }} }}",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.42 0.62 0); }); }",
        **controls).set_up()
    case.run("fsiPisoFoam")
    return case


def same_path(report, folder):
    """Check 1; returns the rigid disc's case."""
    rigid = cavity(folder, "rigid", "type rigid; density 1.5;")
    stiff = cavity(folder, "stiff", "density 1.5; E 1e6;")
    paths = [results.table(case.path, "objects.csv")
             for case in (rigid, stiff)]
    report.check("all steps", len(paths[0]) == len(paths[1]) == STEPS//OUTPUT,
                 f"{len(paths[0])} and {len(paths[1])}")
    speed = max(abs(row["velocityX"]) for row in paths[1])
    spin = max(abs(row["angularVelocityZ"]) for row in paths[1])
    report.check("it moves and turns", speed > 0.01 and spin > 0.05,
                 f"{speed}, {spin}")
    for column, scale in (("velocityX", speed), ("velocityY", speed),
                          ("angularVelocityZ", spin)):
        worst = max(abs(a[column] - b[column])
                    for a, b in zip(*paths))/scale
        print(f"    {column}: {worst:.2e} of the largest apart")
        report.check(f"{column} of rigid and stiff", worst < 0.01,
                     f"{worst} apart")
    for column in ("area", "perimeter"):
        values = [row[column] for row in paths[0]]
        change = (max(values) - min(values))/values[0]
        report.check(f"{column} is kept", change < 1e-12, f"{change}")
    return rigid


def restarted(report, folder, whole):
    """Check 4: the second half again."""
    case = cavity(folder, "restart", "type rigid; density 1.5;",
                  endTime=0.01*STEPS/2)
    case.control(endTime=0.01*STEPS, startFrom="latestTime")
    case.run("fsiPisoFoam")
    # All numbers but the direction of a disc's axes
    last = [{key: value for key, value in
             results.table(c.path, "objects.csv")[-1].items()
             if key not in ("inclination", "deformation")}
            for c in (whole, case)]
    report.check("restart", last[0] == last[1], f"{last[0]} and {last[1]}")


def rests(report, folder, name, shape, material):
    """Check 2."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(30, 30), viscosity=0.002,
        cyclic="xy",
        shapes=f"body {{ {shape} material {{ {material} }} }}",
        placements="a { type listed; shape body; objects ({ centre "
                   "(0.5 0.5 0); velocity (0.3 0.1 0); angularVelocity "
                   "(0 0 3); }); }",
        deltaT=0.01, endTime=0.01*STEPS, writeInterval=STEPS).set_up()
    case.run("fsiPisoFoam")
    energy = [row["kineticEnergy"]
              for row in results.table(case.path, "global.csv")]
    half = max(energy[STEPS//2:])
    print(f"    {name}: {half/energy[0]:.3g} of the first step's energy")
    report.check(f"{name} comes to rest",
                 len(energy) == STEPS and 0 < half < 0.5*energy[0],
                 f"{half} of {energy[0]} in the second half")


def loaded(folder, name, motion, **changes):
    """The rows of two objects, one elastic and one rigid, both with a load."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(30, 30), viscosity=0.01,
        shapes=f"disc {{ {CIRCLE} material {{ density 2; E 100; }}"
               f" motion {{ {motion[0]} }} }}"
               f"star {{ {STAR} material {{ type rigid; density 3; }}"
               f" motion {{ {motion[1]} }} }}",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.3 0.6 0); }); }"
                   "b { type listed; shape star; objects "
                   "({ centre (0.7 0.6 0); }); }",
        deltaT=0.01, endTime=0.2, writeInterval=1, **changes).set_up()
    case.run("fsiPisoFoam")
    return results.table(case.path, "objects.csv")


def given_loads(report, folder):
    """Check 5."""
    falling = loaded(folder, "falling", ("", ""), gravity="(0 -2 0)")
    excess = [-2*(density - 1)*falling[i]["area"]*THICKNESS
              for i, density in ((0, 2), (1, 3))]
    pushed = loaded(folder, "pushed", [
        f"type free; force constant (0 {force:.17g} 0);" for force in excess])
    # The pressure answers gravity's start at once (suddenAcceleration), that of
    # a given force within some steps
    speed = max(abs(row["velocityY"]) for row in falling)
    worst = max(abs(a[c] - b[c]) for a, b in zip(falling[20:], pushed[20:])
                for c in ("velocityX", "velocityY"))/speed
    report.check("given forces in place of gravity",
                 len(falling) == len(pushed) == 40 and worst < 1e-4,
                 f"{len(pushed)} rows, {worst} of the speed apart")

    # In next to no fluid: the torque grows with time, T = 1e-3 t
    torque = "type free; torque table ((0 (0 0 0)) (1 (0 0 1e-3)));"
    turned = loaded(folder, "turned", (torque, torque), density=1e-4)
    # The star's outline is r = 0.12 (1 + 0.3 cos(5 t)): the integral of r^4/4.
    # Polygons have less inertia, the disc's masses at its nodes have more
    sizes = {"disc": 2*math.pi/2,
             "star": 3*math.pi/2*(1 + 3*0.3**2 + 3/8*0.3**4)}
    for i, (name, size) in enumerate(sizes.items()):
        inertia = size*THICKNESS*0.12**4
        spin = 1e-3*0.01*0.01*sum(range(1, 21))/inertia
        found = turned[-2 + i]["angularVelocityZ"]
        print(f"    {name}: turns at {found:.4g}, for a solid {spin:.4g}")
        report.check(f"torque on the {name}", 0.95 < found/spin < 1.04,
                     f"{found}, not {spin}")


def on_incline(folder, name, friction, ranks=1):
    """A disc that starts at rest on the lower wall, after 0.25 s."""
    case = fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 1.2, 0.6), cells=(48, 24),
        density=1e-4, viscosity=0.01, gravity="(7 -7 0)",
        properties="contact { range 1; law {"
                   f" tolerance 1e-6; frictionCoefficient {friction}; }} }}\n",
        shapes="disc { shape { type circle; radius 0.15; } material "
               "{ type rigid; density 1; } }",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.35 0.1525 0); }); }",
        deltaT=0.0025, endTime=0.25, writeInterval=100,
        writePrecision=17).set_up()
    if ranks > 1:
        case.decompose(ranks, 1)
    case.run("fsiPisoFoam", ranks=ranks)
    return results.table(case.path, "objects.csv")[-1]


def incline(report, folder):
    """Check 6. Friction has taken what the normal impulses allow, whatever the
    bounces, and has turned the disc."""
    slides = on_incline(folder, "slides", 0.2)
    speed = 7*0.25
    friction = 0.2*(speed + slides["velocityY"])
    off = abs(slides["velocityX"] - (speed - friction))/speed
    turn = abs(0.15*slides["angularVelocityZ"] + 2*friction)/speed
    print(f"    slides at {slides['velocityX']:.4f} m/s, {off:.1e} off, turns"
          f" at {slides['angularVelocityZ']:.4f}/s, {turn:.1e} off")
    report.check("friction as Coulomb says", off < 0.002 and turn < 0.02,
                 slides)
    rolls = on_incline(folder, "rolls", 1)
    slip = rolls["velocityX"] + 0.15*rolls["angularVelocityZ"]
    print(f"    rolls at {rolls['velocityX']:.4f} m/s, slips at {slip:.1e}")
    report.check("a disc rolls", abs(slip) < 0.01*speed
                 and abs(rolls["velocityX"]/speed - 2/3) < 0.02, rolls)
    other = on_incline(folder, "ranks", 0.2, 3)
    report.check("friction on three ranks", all(
        abs(other[key] - slides[key]) < 1e-8
        for key in ("velocityX", "velocityY", "angularVelocityZ")), other)


def pile(folder, name, *parts):
    """The rows of objects.csv at the end: four discs lie on a fixed bar, one on
    the floor."""
    case = fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 2, 1.25), cells=(64, 40),
        density=1000, viscosity=0.01, gravity="(0 -1 0)", shapes="""
disc { shape { type circle; radius 0.15; }
       material { type rigid; density 2000; } }
bar  { shape { type polygon; file "constant/bar.csv"; }
       material { type rigid; density 1000; } motion { type fixed; } }
""", placements="bar { type inPlace; shape bar; } discs { type listed; shape "
        "disc; objects ("
        + " ".join(f"{{ centre ({x} {y} 0); }}" for x, y in (
            (0.3, 0.62), (0.83, 0.62), (1.17, 0.62), (1, 0.9), (1.8, 0.16)))
        + "); }", deltaT=0.02, endTime=6, writeInterval=300)
    case.text("constant/bar.csv", "0.1 0.35\n1.4 0.35\n1.4 0.45\n0.1 0.45\n")
    case.set_up()
    ranks = case.decompose(*parts) if parts else 1
    case.run("fsiPisoFoam", ranks=ranks)
    rows = results.table(case.path, "objects.csv")
    return {row["object"]: row for row in rows
            if row["time"] == rows[-1]["time"]}, case.values


def contact_force(report, folder):
    """Contact and fluid carry what lies on a bar, and the floor the rest. The
    bar is on all ranks of three."""
    rows, values = pile(folder, "pile")
    thickness = values["box"][2]/values["cells"][0]
    weight = math.pi*0.15**2*thickness*1000
    bar = rows.pop(0)
    carried = -bar["contactForceY"] - bar["forceY"]
    report.check("the bar carries four discs",
                 abs(carried/weight - 4) < 0.01, carried/weight)
    total = bar["contactForceY"] + sum(
        row["contactForceY"] for row in rows.values())
    report.check("the floor carries one disc", abs(total/weight - 1) < 0.01,
                 total/weight)
    between = rows[2]["contactForceX"]
    report.check("discs under a disc are pushed apart",
                 between < -0.3*weight
                 and abs(between + rows[3]["contactForceX"]) < 0.02*weight,
                 between/weight)
    rows[0] = bar
    for parts in ((3, 1), (2, 2)):
        other, _ = pile(folder, "pileOnRanks", *parts)
        error = max(abs(other[o][key] - rows[o][key]) for o in rows
                    for key in ("contactForceX", "contactForceY"))/weight
        report.check(f"contact forces on {parts} ranks", error < 1e-3, error)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    whole = report.attempt("rigid and stiff", same_path, report, folder)
    if whole is not None:
        report.attempt("restart", restarted, report, folder, whole)
    report.attempt("given loads", given_loads, report, folder)
    report.attempt("incline", incline, report, folder)
    report.attempt("contact force", contact_force, report, folder)
    for name, shape, density in (("light", CIRCLE, 0.1), ("star", STAR, 0.3)):
        report.attempt(name, rests, report, folder, name, shape,
                       f"type rigid; density {density};")


if __name__ == "__main__":
    main(sys.argv[1])
