#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies of a file of several pieces, at its own coordinates; and a run on
another mesh than the one that they were seeded for.

    pieces.py FOLDER
"""

import os
import re
import sys

import fsiCase
from refused import refused
import results

CENTRES = ((0.3, 0.3, 0.5), (0.7, 0.6, 0.4))
SHAPE = """body {{ shape {{ type surface; file "two parts.obj"; {} }}
    material {{ type rigid; density 1; }} }}"""


def octahedra():
    """The text of an OBJ of two octahedra, in millimetres."""
    text, first = "", 1
    for centre in CENTRES:
        for axis in range(3):
            for side in (200, -200):
                text += "v {} {} {}\n".format(*(
                    1000*c + side*(i == axis) for i, c in enumerate(centre)))
        for a in (0, 1):
            for b in (2, 3):
                for c in (4, 5):
                    face = (a, b, c) if (a + b + c) % 2 == 0 else (a, c, b)
                    text += "f {} {} {}\n".format(*(first + i for i in face))
        first += 6
    return text


def check_pieces(report, case):
    """One piece, and all, where the file has them."""
    def seed(piece, placement):
        case.values.update(
            shapes=SHAPE.format("scale 1e-3; " + piece),
            placements=f"a {{ type {placement}; shape body; }}")
        case.write()

    seed("", "inPlace")
    refused(report, "two pieces as one are refused", case, "seedObjects",
            ("seedObjectsDict", "two parts.obj", "2 pieces", "'piece'"))
    for piece, centres in (("piece 2;", CENTRES[1:]), ("piece all;", CENTRES)):
        seed(piece, "inPlace")
        case.run("seedObjects")
        folder = os.path.join(case.path, "0/uniform/fsiObjects")
        names = sorted(os.listdir(folder))
        wanted = ["body"] if piece == "piece 2;" else ["body_1", "body_2"]
        report.check(f"{piece} makes {wanted}", names == wanted, str(names))
        for name, centre in zip(names, centres):
            flat = results.numbers(
                results.read(folder, name), "positions")
            n = len(flat)//3
            mean = [sum(flat[i*n:(i + 1)*n])/n for i in range(3)]
            far = max(abs(a - b) for a, b in zip(mean, centre))
            report.check(f"{name} of {piece} is where the file has it",
                         far < 0.01, f"{mean}, not {centre}")


def check_meshes(report, case):
    """A run on the mesh, and on others."""
    def mesh(cells, box=(0, 0, 0, 1, 1, 1)):
        case.values.update(cells=(cells,)*3, box=box)
        case.write()
        case.run("blockMesh")

    log = case.run("fsiPisoFoam")
    report.check("nothing is said on its own mesh",
                 "Objects were seeded" not in log, "a warning")
    mesh(20)
    log = case.run("fsiPisoFoam")
    report.check("a finer mesh is warned of", re.search(
        r"seeded for cells of 0.0625 m, but the mesh's are 0.05", log),
        "no warning")
    mesh(8)
    refused(report, "too coarse a mesh is refused", case, "fsiPisoFoam",
            ("FATAL IO ERROR", "fsiSeeding", "'cellSize'", "body_1",
             "Run seedObjects"))
    mesh(16, (0.25, 0, 0, 1.25, 1, 1))
    refused(report, "a mesh that moved is refused", case, "fsiPisoFoam",
            ("FATAL IO ERROR", "fsiSeeding", "'min'", "Object 0",
             "Run seedObjects"))
    mesh(32, (-0.5, -0.5, -0.5, 1.5, 1.5, 1.5))
    log = case.run("fsiPisoFoam")
    report.check("a larger mesh is warned of",
                 "Objects were seeded in the box" in log, "no warning")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.Case(os.path.join(folder, "case"), box=(0, 0, 0, 1, 1, 1),
                        cells=(16, 16, 16), deltaT=0.01, endTime=0.01)
    with open(os.path.join(case.path, "two parts.obj"), "w",
              encoding="ascii") as stream:
        stream.write(octahedra())
    case.run("blockMesh")
    report.attempt("pieces", check_pieces, report, case)
    report.attempt("meshes", check_meshes, report, case)


if __name__ == "__main__":
    main(sys.argv[1])
