#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that are clamped, tied by springs, or move in some directions only, in
a fluid.

    heldBodies.py FOLDER

1. A flap of rubber that stands on the floor of a channel is bent downstream,
   its root stays, and the wall that it reaches through does not push it.
2. Rigid bodies: a disc on springs that moves along y only stays on its line, a
   bar that hangs from a clamped node turns about it.
3. The same in three dimensions: a flap of rubber, and a block that turns about
   z only.
4. All of this is the same on two and three ranks and after a restart.
5. The table of followed places has the tip and the root of the flap, and the
   skin of the disc, whose mean moves as the disc.
6. Clamps that move, see driven.py.
"""

import math
import os
import sys

import driven
import fsiCase
import results

STEPS = 12

PLANE = """
flap
{
    shape    { type polygon; file "constant/flap.csv"; }
    material { type neoHookean; density 2; E 100; strain smoothed; }
    hold     { root { type halfSpace; normal (0 -1 0); } }
    follow
    {
        tip  { type nearest; point (0.4 0.5 0); }
        root { type halfSpace; normal (0 -1 0); }
    }
}
disc
{
    shape    { type circle; radius 0.15; }
    material { type rigid; density 1.5; }
    hold     { spring { type sphere; centre (0 0 0); radius 1; stiffness 5; } }
    motion   { type free; translations (y); rotations (); force constant
               (0 0.05 0); }
    follow   { skin { type sphere; centre (0 0 0); radius 1; } }
}
bar
{
    shape    { type ellipse; semiAxes (0.12 0.24); }
    material { type rigid; density 3; }
    hold     { pin { type nearest; point (0 0.24 0); } }
}
"""

SOLID = """
flap
{
    shape    { type ellipsoid; semiAxes (0.13 0.4 0.2); }
    material { density 2; E 100; }
    hold     { root { type halfSpace; point (0 -0.25 0); normal (0 -1 0); } }
}
block
{
    shape    { type ellipsoid; semiAxes (0.24 0.13 0.2); }
    material { type rigid; density 1.5; }
    motion   { type free; translations (); rotations (z); }
}
"""


def channel(folder, name, solid=False, **changes):
    """Flow past the bodies."""
    case = fsiCase.Case(
        os.path.join(folder, name),
        box=(0, 0, 0, 2.4, 0.96, 0.8) if solid else (0, 0, 2.4, 1),
        cells=(30, 12, 10) if solid else (72, 30), viscosity=0.02,
        velocity="(1 0 0)", walls={"top": "(1 0 0)"}, cyclic="xz" if solid
        else "x", shapes=SOLID if solid else PLANE,
        placements="""
        a { type listed; shape flap; objects ({ centre (0.5 0.25 0.4); }); }
        b { type listed; shape block; objects ({ centre (1.5 0.5 0.4); }); }
        """ if solid else """
        a { type inPlace; shape flap; }
        b { type listed; shape disc; objects ({ centre (1.1 0.5 0); }); }
        c { type listed; shape bar; objects ({ centre (1.8 0.6 0); }); }
        """, gravity="(0 -1 0)", **{
            "deltaT": 0.02, "endTime": 0.02*STEPS, "writeInterval": STEPS//2,
            "writeFormat": "binary", **changes})
    if not solid:
        with open(os.path.join(case.path, "constant/flap.csv"), "w",
                  encoding="ascii") as stream:
            stream.write("0.4 -0.1\n0.55 -0.1\n0.55 0.5\n0.4 0.5\n")
    return case.set_up()


def moves(case, shape):
    """Places of the nodes of the one object of a shape at the start, and how
    they have moved at the end."""
    flat = [results.numbers(results.read(
        case.path, time, "uniform/fsiObjects", shape), "positions")
            for time in (results.times(case.path)[0],
                         results.times(case.path)[-1])]
    n_dims = case.dimensions()
    n = len(flat[0])//n_dims
    start, end = (list(zip(*[values[i*n:(i + 1)*n] for i in range(n_dims)]))
                  for values in flat)
    return [(a, tuple(y - x for x, y in zip(a, b)))
            for a, b in zip(start, end)]


def flap_bends(report, case, floor):
    """Check 1."""
    nodes = moves(case, "flap")
    root = max(math.hypot(*d) for x, d in nodes if x[1] < floor)
    tip = max(nodes, key=lambda node: node[0][1])[1]
    dims = f"{case.dimensions()}D"
    report.check(f"{dims}: the root stays", root < 1e-6, f"{root}")
    report.check(f"{dims}: the end bends downstream",
                 0.001 < tip[0] < 0.5 and abs(tip[1]) < abs(tip[0]), f"{tip}")


def rigid_bodies(report, case):
    """Check 2."""
    disc = [d for _, d in moves(case, "disc")]
    report.check("a disc moves along y", max(abs(d[0]) for d in disc) < 1e-9
                 and abs(disc[0][1]) > 1e-4
                 and max(abs(d[1] - disc[0][1]) for d in disc) < 1e-9,
                 f"{disc[0]}")
    bar = moves(case, "bar")
    pin = min(math.hypot(*d) for _, d in bar)
    foot = max(math.hypot(*d) for _, d in bar)
    report.check("a bar turns about its pin", pin < 1e-6 and foot > 1e-3,
                 f"{pin}, {foot}")


def followed(report, case):
    """Check 5; the rows, for a comparison with other runs."""
    rows = results.table(case.path, "followed.csv")
    last = {row["shape"] + "." + row["place"]: row for row in rows[-3:]}
    report.check("places that are followed", sorted(last) == [
        "disc.skin", "flap.root", "flap.tip"], f"{sorted(last)}")
    tip = max(moves(case, "flap"), key=lambda n: n[0][1] - n[0][0])
    place = [last["flap.tip"]["position" + x] for x in "XY"]
    report.check("the tip is a node", all(
        abs(a + d - x) < 1e-12 for a, d, x in zip(*tip, place)),
                 f"{place}, {tip}")
    report.check("the root stays in its place", all(
        abs(last["flap.root"][key]) < 1e-6
        for key in ("velocityX", "velocityY")), f"{last['flap.root']}")
    disc = [row for row in results.table(case.path, "objects.csv")
            if row["shape"] == "disc"][-1]
    skin = last["disc.skin"]
    report.check("the skin moves as the disc", all(
        abs(skin["position" + x] - disc["centroid" + x]) < 1e-6
        and abs(skin["velocity" + x] - disc["velocity" + x]) < 1e-9
        for x in "XY"), f"{skin}, {disc}")
    return rows[-3:]


def restarted(folder, name, whole, **changes):
    """The largest difference of a run that stops in the middle."""
    case = channel(folder, name, endTime=0.02*STEPS/2, **changes)
    case.run("fsiPisoFoam")
    case.control(endTime=0.02*STEPS, startFrom="latestTime")
    case.run("fsiPisoFoam")
    return results.difference(whole.path, case.path)


def ranks(folder, name, whole, parts, **changes):
    """The largest difference of a run on ranks."""
    case = channel(folder, name, **changes)
    case.run("fsiPisoFoam", ranks=case.decompose(*parts))
    return results.difference(whole.path, case.path, ("", "processor0"))


def main(folder):
    """All checks."""
    report = fsiCase.Report()
    for solid in (False, True):
        changes = {"solid": solid, "writeFormat": "ascii",
                   "writePrecision": 17}
        name = "solid" if solid else "plane"
        case = channel(folder, name, **changes)
        case.run("fsiPisoFoam")
        flap_bends(report, case, -0.01)
        report.attempt("checkObjects", case.run, "checkObjects")
        if not solid:
            rigid_bodies(report, case)
            places = followed(report, case)
        else:
            block = [d for _, d in moves(case, "block")]
            report.check("a block turns about z",
                         max(abs(d[2]) for d in block) < 1e-9
                         and max(abs(d[0]) for d in block) > 1e-4,
                         f"{block[0]}")
        apart = restarted(folder, name + "Restart", case, **changes)
        report.check(f"{name}: restart", apart == 0, f"{apart}")
        # The last cut goes along the plane of symmetry of the flap
        for parts in ((2, 1), (3, 1)) if not solid else ((3, 1), (1, 1, 2)):
            n = math.prod(parts)
            apart = ranks(folder, f"{name}{n}", case, parts, **changes)
            print(f"    {name} on {n} ranks: {apart:.1e} apart")
            report.check(f"{name} on {n} ranks", apart < 1e-6, f"{apart}")
            if not solid:
                other = results.table(os.path.join(folder, f"{name}{n}"),
                                      "followed.csv")[-3:]
                report.check(f"places on {n} ranks", all(
                    abs(a["positionX"] - b["positionX"]) < 1e-6
                    for a, b in zip(places, other)), f"{places}, {other}")
    report.attempt("clamps that move", driven.check, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
