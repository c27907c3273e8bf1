# SPDX-License-Identifier: GPL-3.0-or-later
"""Clamps that move: a body of which all nodes are held moves as one with the
prescribed motion does, and the root of a flap goes where its motion says."""

import math
import os

import fsiCase
import results

MOTION = """motion
{{
    type several;
    motions
    (
        {{ type oscillating; amplitude (0.1 0.05 0); frequency 0.5; }}
        {{ type rotating; angularVelocity (0 0 {}); }}
    );
}}"""

STEP, STEPS = 0.02, 30


def moved(folder, name, shapes, scheme="Euler", **changes):
    """Bodies in a closed box of a viscous fluid."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(36, 36), viscosity=0.05,
        shapes=shapes, time_scheme=scheme,
        placements="a { type listed; shape body; objects ({ centre (0.45 0.5 "
                   "0); rotation 20; }); }", **{
            "deltaT": STEP, "endTime": STEP*STEPS, "writePrecision": 17,
            "properties": "output { objectsEvery 1; }",
            "writeInterval": STEPS//2, **changes})
    return case.set_up()


def alike(report, folder, scheme, turn):
    """An ellipse that is held whole, and one whose motion is prescribed. The
    one turns about the mean of its nodes, the other about its centroid. With
    backward it has its forces where it is expected, the other where it is."""
    shape = ("body {{ shape {{ type ellipse; semiAxes (0.2 0.12); }} material "
             "{{ type neoHookean; density 1; E 100; }} {} {} }}")
    held = "hold { all { type sphere; centre (0 0 0); radius 1; } }"
    last = []
    for name, text in (("prescribed", ""), ("driven", held)):
        case = moved(folder, f"{name}{scheme}{turn}", shape.format(
            text, MOTION.format(turn)), scheme)
        case.run("fsiPisoFoam")
        last.append(results.table(case.path, "objects.csv")[-1])
    one, other = last
    keys = ["angularVelocityZ", "inclination"]
    if turn == 0:
        keys += ["centroidX", "centroidY", "velocityX", "velocityY"]
    apart = {key: abs(one[key] - other[key]) for key in keys}
    force = [math.hypot(row["forceX"], row["forceY"]) for row in last]
    name = f"{scheme}, {'turning' if turn else 'swinging'}"
    print(f"    {name}: force {force[0]:.5g} N, held {force[1]:.5g} N")
    report.check(f"{name}: a body that is held whole moves as prescribed",
                 max(apart.values()) < 1e-7, f"{apart}")
    exactly = scheme == "Euler" and turn == 0
    report.check(f"{name}: the fluid's force is equal",
                 abs(force[1]/force[0] - 1) < (1e-5 if exactly else 0.02),
                 f"{one}, {other}")


FLAP = """body
{
    shape    { type rectangle; length 0.1; width 0.5; }
    material { type neoHookean; density 2; E 2000; strain smoothed; }
    hold     { root { type halfSpace; point (0 -0.2 0); normal (0 -1 0); } }
    follow
    {
        root { type halfSpace; point (0 -0.2 0); normal (0 -1 0); }
        tip  { type nearest; point (0 0.25 0); }
    }
""" + MOTION.format(0).replace("{{", "{").replace("}}", "}") + "\n}"


def flap(report, folder):
    """The root of a flap, on ranks and after a restart."""
    case = moved(folder, "flap", FLAP)
    case.run("fsiPisoFoam")
    rows = results.table(case.path, "followed.csv")
    root = [row for row in rows if row["place"] == "root"]
    tip = [row for row in rows if row["place"] == "tip"]
    missed = max(
        math.hypot(*(row["position" + x] - root[0]["position" + x]
                     - amplitude*(swing(row["time"]) - swing(STEP))
                     for x, amplitude in (("X", 0.1), ("Y", 0.05))))
        for row in root)
    report.check("the root of a flap goes with its clamp", missed < 1e-6,
                 f"{missed}")
    lag = tip[-1]["positionX"] - tip[0]["positionX"] - (
        root[-1]["positionX"] - root[0]["positionX"])
    report.check("its tip lags behind", -0.2 < lag < -0.001, f"{lag}")
    half = moved(folder, "half", FLAP, endTime=STEP*STEPS/2)
    half.run("fsiPisoFoam")
    half.control(endTime=STEP*STEPS, startFrom="latestTime")
    half.run("fsiPisoFoam")
    apart = results.difference(case.path, half.path)
    report.check("a driven flap: restart", apart == 0, f"{apart}")
    ranks = moved(folder, "ranks", FLAP)
    ranks.run("fsiPisoFoam", ranks=ranks.decompose(3, 1))
    apart = results.difference(case.path, ranks.path, ("", "processor0"))
    report.check("a driven flap on three ranks", apart < 1e-6, f"{apart}")


def swing(time):
    """The sine of the motion."""
    return math.sin(math.pi*time)


def check(report, folder):
    """All of this."""
    for scheme in ("Euler", "backward"):
        for turn in (0, 1):
            alike(report, folder, scheme, turn)
    flap(report, folder)
