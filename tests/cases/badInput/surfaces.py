#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad surfaces from files end seedObjects in a FOAM FATAL IO ERROR that names
the dictionary, the key, the file and what is wrong with it; bodies that turn
inside out end fsiPisoFoam in an error that names the object.

    surfaces.py FOLDER
"""

import itertools
import os
import re
import sys

import fsiCase
from refused import refused
import results

N = 16
DT = 0.01

SHAPES = """body {{ shape {{ type surface; file "{}"; {} }}
    material {{ density 1000; E {}; }} {} }}
"""


def cuboid(a, b, c, centre=(0, 0, 0)):
    """Twelve triangles of a box with these edges, normals outwards."""
    def corner(*sides):
        return tuple(m + s*e/2 for m, s, e in zip(centre, sides, (a, b, c)))

    triangles = []
    for axis, side in itertools.product(range(3), (-1, 1)):
        def place(u, v, axis=axis, side=side):
            sides = [0, 0, 0]
            sides[axis], sides[(axis + 1) % 3], sides[axis - 1] = side, u, v
            return corner(*sides)

        loop = [place(*uv) for uv in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        loop = loop[::side]
        triangles += [(loop[0], loop[1], loop[2]), (loop[0], loop[2], loop[3])]
    return triangles


def crossed(triangles):
    """A corner drawn through the opposite side."""
    tip = triangles[0][0]
    return [tuple((-2*p[0], 0.3*p[1], 0.3*p[2]) if p == tip else p
                  for p in t) for t in triangles]


def stl(triangles):
    """The text of an STL file."""
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in triangle)
        + "endloop\nendfacet\n" for triangle in triangles)
    return f"solid body\n{facets}endsolid body\n"


BOX = cuboid(0.4, 0.45, 0.5)

# Name: file, its text, entries of the shape, of the object, the placement's
# objects, texts of the message
MIDDLE = "{ centre (0.5 0.5 0.5); }"
REFUSED = {
    "a surface that is not closed": (
        "open.stl", stl(BOX[1:]), "", MIDDLE,
        ("'file'", "open.stl", "not closed", "open edges")),
    "a vessel that can move": (
        "vessel.stl", stl(BOX), "inside yes;", MIDDLE,
        ("'inside'", "rigid", "fixed")),
    "a surface that cuts itself": (
        "crossed.stl", stl(crossed(BOX)), "", MIDDLE,
        ("'file'", "crossed.stl", "triangles that meet")),
    "a surface of two pieces": (
        "two.stl", stl(cuboid(0.2, 0.2, 0.2) + cuboid(
            0.2, 0.2, 0.2, (0.4, 0, 0))), "", MIDDLE,
        ("'file'", "two.stl", "2 pieces")),
    "a plate thinner than three cells": (
        "plate.stl", stl(cuboid(0.5, 0.5, 0.1)), "", MIDDLE,
        ("'shape'", "body", "3 cells", "thinnest")),
    "an empty surface": (
        "empty.stl", stl([]), "", MIDDLE, ("'file'", "empty.stl")),
    "a surface in millimetres": (
        "large.stl", stl(cuboid(400, 450, 500)), "", MIDDLE,
        ("'shape'", "body", "millimetres", "'scale'", "1e-3")),
    "a surface scaled to nothing": (
        "box.stl", stl(BOX), "scale 1e-3;", MIDDLE,
        ("'shape'", "body", "3 cells")),
    "a surface with a wrong key": (
        "box.stl", stl(BOX), "size 2;", MIDDLE, ("size", "scale")),
    "a scale below zero": (
        "box.stl", stl(BOX), "scale -1;", MIDDLE, ("scale", "-1")),
    "surfaces that overlap": (
        "box.stl", stl(BOX), "scale 0.6;",
        "{ centre (0.3 0.5 0.5); } { centre (0.5 0.52 0.5); }",
        ("'objects'", "object 1", "overlaps object 0")),
    "a surface that leaves the box": (
        "box.stl", stl(BOX), "", "{ centre (0.85 0.5 0.5); }",
        ("'objects'", "object 0", "not in the domain")),
    "an absurd quaternion": (
        "box.stl", stl(BOX), "", "{ centre (0.5 0.5 0.5); rotation "
        "{ quaternion (1e200 (0 1e200 0)); } }", ("'quaternion'", "1e15")),
    "an absurd axis": (
        "box.stl", stl(BOX), "", "{ centre (0.5 0.5 0.5); rotation "
        "{ axis (1e200 0 0); angle 1; } }", ("'axis'", "1e15")),
    "a surface of a size near zero": (
        "dust.stl", stl(cuboid(1e-30, 1e-30, 1e-30)), "", MIDDLE,
        ("'shape'", "body", "3 cells")),
    "a piece that is not there": (
        "box.stl", stl(BOX), "piece 2;", MIDDLE,
        ("'file'", "box.stl", "1 pieces", "'piece'")),
    "a file that is not there": (
        None, "", "", MIDDLE, ("'file'", "nowhere.stl", "no such file")),
    "a file of another kind": (
        "box.txt", "solid\n", "", MIDDLE,
        ("'file'", "box.txt", "valid formats", "stl")),
    "an STL of words": (
        "words.stl", "solid body\nfacet this is none\nendsolid\n", "", MIDDLE,
        ("'file'", "words.stl")),
    "an STL with a coordinate that fits no float": (
        "far.stl", re.sub(r"vertex \S+", "vertex 1e300", stl(BOX), count=1),
        "", MIDDLE, ("'file'", "far.stl", "1e15")),
    "an STL that is cut off": (
        "cut.stl", stl(BOX)[:700], "", MIDDLE, ("'file'", "cut.stl")),
}


def write(case, name, text, entries, objects):
    """The surface and the dictionary of the objects."""
    if name is not None:
        with open(os.path.join(case.path, name), "w",
                  encoding="ascii") as stream:
            stream.write(text)
    case.values.update(
        shapes=SHAPES.format(name or "nowhere.stl", entries, 1e4, ""),
        placements=f"a {{ type listed; shape body; objects ({objects}); }}")
    case.write()


def check_surfaces(report, case):
    """A good one is accepted, the others are not."""
    write(case, "box.stl", stl(BOX), "", MIDDLE)
    report.attempt("a box from an STL is accepted", case.run, "seedObjects")
    for name, (file, text, entries, objects, texts) in REFUSED.items():
        write(case, file, text, entries, objects)
        refused(report, f"{name} is refused", case, "seedObjects",
                ("FATAL IO ERROR", "seedObjectsDict", *texts))


def mirror(case, key, value):
    """Sets the x components of all nodes in the state by value(x)."""
    path = os.path.join(case.path, "0/uniform/fsiObjects/body")
    text = results.without_sums(results.read(path))
    flat = results.numbers(text, "positions")
    n = len(flat)//3
    new = [value(x) for x in flat[:n]]
    old = results.numbers(text, key)[n:]
    body = "\n".join(repr(v) for v in new + old)
    text = re.sub(rf"(?ms)^{key}\s.*?;",
                  f"{key} List<scalar> {3*n}({body});", text)
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)


def check_inverted(report, folder):
    """A body that is inside out in its state, and one that turns so."""
    names = ("tetrahedra", "object 0", "constant/fsiObjects/body", "inverted",
             "deltaT")
    for name, key, value in (
            ("a state inside out", "positions", lambda x: 1 - x),
            ("a body that turns inside out in a step", "velocities",
             lambda x: 1.4*(0.5 - x)/DT)):
        case = fsiCase.Case(
            os.path.join(folder, key), box=(0, 0, 0, 1, 1, 1),
            cells=(N, N, N), density=1, deltaT=DT, endTime=2*DT,
            writePrecision=17, properties="coupling { type none; }\n",
            shapes="body { shape { type sphere; radius 0.2; } "
                   "material { density 1000; E 1; } }",
            placements=f"a {{ type listed; shape body; objects ({MIDDLE}); }}"
        ).set_up()
        mirror(case, key, value)
        refused(report, f"{name} is refused", case, "fsiPisoFoam",
                ("FATAL ERROR", *names))


def check_planes(report, folder):
    """A surface in a mesh of two dimensions, an outline in three."""
    case = fsiCase.Case(os.path.join(folder, "plane"), cells=(N, N))
    case.run("blockMesh")
    write(case, "box.stl", stl(BOX), "", "{ centre (0.5 0.5 0); }")
    refused(report, "a surface in a plane is refused", case, "seedObjects",
            ("FATAL IO ERROR", "seedObjectsDict", "surface",
             "3 dimensions", "polygon"))
    case = fsiCase.Case(os.path.join(folder, "space"),
                        box=(0, 0, 0, 1, 1, 1), cells=(N, N, N))
    case.run("blockMesh")
    case.values.update(
        shapes="body { shape { type polygon; file \"a.csv\"; } "
               "material { density 1; E 1; } }",
        placements=f"a {{ type listed; shape body; objects ({MIDDLE}); }}")
    case.write()
    refused(report, "a polygon in space is refused", case, "seedObjects",
            ("FATAL IO ERROR", "seedObjectsDict", "polygon",
             "2 dimensions", "surface"))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.Case(os.path.join(folder, "case"), box=(0, 0, 0, 1, 1, 1),
                        cells=(N, N, N), density=1000)
    case.run("blockMesh")
    check_surfaces(report, case)
    report.attempt("dimensions", check_planes, report, folder)
    report.attempt("inverted bodies", check_inverted, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
