#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""seedObjects in three dimensions with every type of placement, what it
refuses, and checkObjects on what it wrote and on objects made wrong.

    solids.py FOLDER
"""

import os
import re
import shutil
import sys

import fsiCase
import results

N = 32
H = 1/N

SHAPES = """sphere { shape { type sphere; radius 0.08; }
    material { density 1100; E 1e4; } }
egg { shape { type ellipsoid; semiAxes (0.12 0.06 0.06); }
    material { density 1100; E 1e4; } }
post { shape { type sphere; radius 0.1; }
    material { density 1100; E 1e4; } motion { type fixed; } }
"""

PLACEMENTS = """posts { type listed; shape post;
    objects ({ centre (0.5 0.02 0.5); }); }
eggs { type listed; shape egg; velocity (0 0 0.5); objects
( { centre (0.15 0.3 0.8); }
  { centre (0.5 0.3 0.8); rotation { axis (0 1 0); angle 90; } }
  { centre (0.85 0.3 0.8); rotation { quaternion (1 (0 0 1)); }
    angularVelocity (1 2 3); } ); }
rows { type lattice; shape sphere; counts (4 1 2);
    region { min (0 0.75 0); max (1 1 0.5); } }
fromFile { type csv; shape sphere; file "constant/objects.csv"; }
loose { type random; shape egg; number 3; seed 4; minimumGap 0.02;
    region { min (0 0.45 0); max (1 0.72 0.5); } }
dense { type packed; shape sphere; number 6; minimumGap 0.01; sweeps 50;
    wallGap 0; region { min (0 0.5 0.55); max (1 1 1); } }
"""

# Objects: the post, then by the order of the placements
N_OBJECTS = 1 + 3 + 8 + 2 + 3 + 6


def box(folder, name, shapes=SHAPES, placements=PLACEMENTS, cells=(N, N, N)):
    """A cube with walls, meshed."""
    corners = (0,)*len(cells) + (1,)*len(cells)
    case = fsiCase.Case(
        os.path.join(folder, name), box=corners, cells=cells, shapes=shapes,
        placements=placements, writeFormat="ascii", writePrecision=17)
    with open(os.path.join(case.path, "constant/objects.csv"), "w",
              encoding="ascii") as stream:
        stream.write("x,y,z,axisX,axisY,axisZ,angle\n"
                     "0.15,0.1,0.15,1,1,0,30\n0.85,0.1,0.15,0,0,1,0\n")
    case.run("blockMesh")
    return case


def span(points):
    """Extents of points."""
    return [max(c) - min(c) for c in zip(*points)]


def check_seeded(report, case):
    """What is written: numbers, places, rotations, gaps to the walls."""
    log = case.run("seedObjects")
    state = results.state(case.path, "0")
    report.check("all objects are there", len(state) == N_OBJECTS,
                 f"{len(state)} objects")
    report.check("the report gives volumes",
                 "volume fraction" in log and " m3, mass" in log, log[-500:])

    eggs = [points for shape, points, _ in state.values() if shape == "egg"]
    longest = [max(range(3), key=span(points).__getitem__)
               for points in eggs[:3]]
    report.check("rotations turn the long axis", longest == [0, 2, 1],
                 f"{longest}")
    flat = [c for shape, points, _ in state.values() if shape != "post"
            for p in points for c in p]
    report.check("free objects are in the box",
                 min(flat) > 0 and max(flat) < 1, f"{min(flat)} {max(flat)}")
    radii = [span(points) for shape, points, _ in state.values()
             if shape == "sphere"]
    report.check("spheres have their size",
                 all(abs(d - 0.16) < 0.02*0.16 for r in radii for d in r),
                 f"{min(map(min, radii))} {max(map(max, radii))}")

    first = results.read(case.path, "0/uniform/fsiObjects/egg")
    case.run("seedObjects")
    report.check("the same seed gives the same state",
                 results.read(case.path, "0/uniform/fsiObjects/egg") == first)


def positions(case, shape, change):
    """Applies change(columns) to the node coordinates of the objects of a
    shape, a list per object and direction."""
    path = os.path.join(case, "0/uniform/fsiObjects", shape)
    text = results.without_sums(results.read(path))
    flat = results.numbers(text, "positions")
    n = len(flat)//(3*len(results.numbers(text, "objectIds")))
    columns = [flat[i:i + n] for i in range(0, len(flat), n)]
    change(columns)
    values = "\n".join(repr(v) for column in columns for v in column)
    text = re.sub(r"(?ms)^positions\s.*?;",
                  f"positions List<scalar> {len(flat)}({values});", text)
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)


def moved(direction, distance):
    """The first object of a shape moved."""
    def change(columns):
        columns[direction][:] = [x + distance for x in columns[direction]]
    return change


def swollen(columns):
    """The first object 1 % wider."""
    middle = sum(columns[0])/len(columns[0])
    columns[0][:] = [middle + 1.01*(x - middle) for x in columns[0]]


def folded(columns):
    """A node of the first object beyond the other side of it."""
    for column in columns[:3]:
        column[0] = 3*sum(column)/len(column) - 2*column[0]


FAULTS = {
    # The first sphere of the lattice onto the second, 0.25 m away
    "Objects overlap": moved(0, 0.2),
    "Objects are outside the domain": moved(1, 0.2),
    "Volumes are off": swollen,
    "Surfaces cut themselves": folded,
}


def check_faults(report, folder, case):
    """checkObjects passes what was seeded and names each fault."""
    text = report.attempt("sound objects", case.run, "checkObjects")
    report.check("sound objects pass",
                 text is not None and "Objects are sound" in text,
                 str(text)[-400:])
    for name, change in FAULTS.items():
        wrong = os.path.join(folder, name.replace(" ", ""))
        shutil.copytree(case.path, wrong)
        positions(wrong, "sphere", change)
        try:
            fsiCase.run(wrong, "checkObjects")
            report.check(f"{name}: noticed", False, "checkObjects passes")
        except RuntimeError:
            log = results.read(wrong, "log.checkObjects")
            report.check(f"{name}: noticed",
                         name in log and "Objects are not sound" in log,
                         log[-400:])


def sphere(radius, entries=""):
    """A dictionary of shapes."""
    return (f"sphere {{ shape {{ type sphere; radius {radius}; }} "
            f"material {{ density 1100; E 1e4; }} {entries} }}\n")


def listed(*centres):
    """A dictionary of placements."""
    objects = " ".join(f"{{ centre ({c}); }}" for c in centres)
    return f"a {{ type listed; shape sphere; objects ({objects}); }}\n"


MIDDLE = "0.5 0.5 0.5"
REFUSED = {
    # Name: shapes, placements, texts of the message
    "objects that overlap": (
        sphere(0.1), listed(MIDDLE, "0.625 0.5625 0.5"),
        ("object 1 (sphere of placement a", "overlaps object 0",
         "(0.625 0.5625 0.5)", "'objects'")),
    "an object that leaves the box": (
        sphere(0.1), listed("0.5 0.5 0.9375"),
        ("object 0", "not in the domain", "(0.5 0.5 0.9375)")),
    "a sphere in millimetres": (
        sphere(100), listed(MIDDLE), ("'shape'", "sphere", "millimetres")),
    "a sphere larger than the box": (
        sphere(0.7), listed(MIDDLE), ("'shape'", "m3", "domain")),
    "a sphere of two cells": (
        sphere(H), listed(MIDDLE), ("'shape'", "3 cells")),
    "an outline": (
        "sphere { shape { type circle; radius 0.1; } "
        "material { density 1100; E 1e4; } }", listed(MIDDLE),
        ("circle", "2 dimensions", "sphere")),
    "a rotation without an angle": (
        sphere(0.1),
        "a { type listed; shape sphere; objects "
        "({ centre (0.5 0.5 0.5); rotation { axis (1 0 0); } }); }",
        ("angle", "rotation")),
    "a million million objects": (
        sphere(0.1), "a { type lattice; shape sphere; "
        "counts (10000 10000 10000); }", ("'counts'", "no room")),
    "80 % of the volume": (
        sphere(0.1), "a { type packed; shape sphere; volumeFraction 0.8; "
        "minimumGap 0; wallGap 0; }", ("'volumeFraction'", "no room")),
    "an area fraction": (
        sphere(0.1), "a { type packed; shape sphere; areaFraction 0.1; }",
        ("'areaFraction'", "volumeFraction")),
}


def check_refused(report, case, refused):
    """seedObjects must end in an error that names file, key and object."""
    for name, (shapes, placements, texts) in refused.items():
        case.file("system/seedObjectsDict",
                  f"shapes\n{{\n{shapes}\n}}\n"
                  f"placements\n{{\n{placements}\n}}\n")
        try:
            case.run("seedObjects", limit=60)
            report.check(f"{name} is refused", False, "it is accepted")
        except RuntimeError:
            log = results.read(case.path, "log.seedObjects")
            missing = [t for t in (*texts, "seedObjectsDict",
                                   "FOAM FATAL IO ERROR") if t not in log]
            report.check(f"{name} is refused", not missing,
                         f"{missing} not in: " + " ".join(
                             log[log.find("--> FOAM"):][:600].split()))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = box(folder, "cube")
    if report.attempt("seeding", check_seeded, report, case) is None:
        check_faults(report, folder, case)
    check_refused(report, case, REFUSED)
    plane = box(folder, "square", cells=(N, N))
    check_refused(report, plane, {
        "a sphere in a plane": (
            sphere(0.1), listed("0.5 0.5 0"),
            ("sphere", "3 dimensions", "circle")),
    })


if __name__ == "__main__":
    main(sys.argv[1])
