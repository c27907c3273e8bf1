#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields on two ranks, and across a seam, are those of one rank where only some
decompositions show it:

    decomposition.py FOLDER

a film on the side between the ranks, or on the seam; the reference cell of the
pressure with the weak coupling; a state of one rank that goes on on two. Ranks
in a row and in boxes, and one without cells, hold the objects of one rank.
"""

import os
import re
import sys

import anyRanks
import fsiCase
import results

CONTROLS = {"writeFormat": "ascii", "writePrecision": 17,
            "writeControl": "runTime",
            "p_tolerance": 1e-12, "U_tolerance": 1e-12}

NX, NY = 48, 24
BOXES = """
box
{
    shape { type polygon; file "box.csv"; }
    material { density 1; E 100; }
    motion { type translating; velocity (0.1 0 0); }
}
"""


def on_two_ranks(case, *options):
    """Runs a case on two ranks, side by side in x, and puts it together."""
    case.run("fsiPisoFoam", ranks=case.decompose(2, 1, options=options))
    case.run("reconstructPar", "-latestTime")
    return case


def field(case, name):
    """Values at the last time."""
    return results.field(case.path, results.times(case.path)[-1], name)


def difference(a, b):
    """Largest difference over the largest value."""
    return (max(abs(x - y) for x, y in zip(a, b))
            / max(abs(x) for x in a))


def level(p):
    """The pressure less its mean; of cells inside the objects, 0."""
    mean = sum(p)/sum(x != 0 for x in p)
    return [x - mean if x else 0 for x in p]


def film(folder, name, shift):
    """Two boxes with a film of 0.8 cells between them, in a periodic box."""
    objects = " ".join(f"{{ centre ({(x + shift) % 2} 0.5 0); }}"
                       for x in (1 - 1/6, 1 + 1/6))
    case = fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 2, 1), cells=(NX, NY),
        cyclic="x", shapes=BOXES,
        placements=f"boxes {{ type listed; shape box; objects ({objects}); }}",
        properties="contact { range 0.1; law { type none; } }\n",
        deltaT=0.01, endTime=0.03, writeInterval=0.03, **CONTROLS)
    with open(os.path.join(case.path, "box.csv"), "w",
              encoding="ascii") as stream:
        stream.write("-0.15,-0.2\n0.15,-0.2\n0.15,0.2\n-0.15,0.2\n")
    return case.set_up()


def check_film(report, folder):
    """A film is the same wherever it lies."""
    one = film(folder, "film", 0)
    one.run("fsiPisoFoam")
    p = level(field(one, "p"))
    two = on_two_ranks(film(folder, "film-ranks", 0))
    error = difference(p, level(field(two, "p")))
    report.check("a film between two ranks", error < 1e-6, f"{error}")
    seam = film(folder, "film-seam", 1)
    seam.run("fsiPisoFoam")
    moved = level(field(seam, "p"))
    back = [moved[NX*j + (i + NX//2) % NX]
            for j in range(NY) for i in range(NX)]
    error = difference(p, back)
    report.check("a film on the seam", error < 1e-6, f"{error}")


def cavity(folder, name, properties, **controls):
    """A driven cavity with a disc."""
    return fsiCase.Case(
        os.path.join(folder, name), walls={"top": "(1 0 0)"},
        shapes="disc { shape { type circle; radius 0.15; }"
               " material { density 10; E 1000; } }",
        placements="a { type listed; shape disc;"
                   " objects ({ centre (0.5 0.6 0); }); }",
        properties=properties, deltaT=0.01, **CONTROLS, **controls).set_up()


def check_weak(report, folder):
    """One reference cell, not one per rank."""
    weak = {"properties": fsiCase.THESIS + "coupling { type weak; }\n",
            "endTime": 0.1, "writeInterval": 0.1}
    one = cavity(folder, "weak", **weak)
    one.run("fsiPisoFoam")
    two = on_two_ranks(cavity(folder, "weak-ranks", **weak))
    for name, values in (("U", field), ("p", lambda *a: level(field(*a)))):
        error = difference(values(one, name), values(two, name))
        report.check(f"weak coupling on two ranks, {name}", error < 1e-6,
                     f"{error}")


def check_restart(report, folder):
    """The state of one rank goes on on two as on one."""
    controls = {"properties": "", "endTime": 0.1, "writeInterval": 0.05}
    one = cavity(folder, "whole", **controls)
    one.run("fsiPisoFoam")
    two = cavity(folder, "continued", **{**controls, "endTime": 0.05})
    two.run("fsiPisoFoam")
    control = os.path.join(two.path, "system/controlDict")
    fsiCase.set_entry(control, "endTime", 0.1)
    fsiCase.set_entry(control, "startFrom", "latestTime")
    on_two_ranks(two, "-latestTime")
    error = difference(field(one, "U"), field(two, "U"))
    report.check("a state of one rank goes on on two", error < 1e-9, f"{error}")


def check_redistributed(report, folder):
    """Two ranks' state goes on on three; redistributePar gives the third one
    the objects of another time, which do not count."""
    serial = anyRanks.channel(os.path.join(folder, "serial"))
    serial.run("fsiPisoFoam")
    case = anyRanks.channel(os.path.join(folder, "redistributed"))
    case.control(endTime=0.02)
    case.run("fsiPisoFoam", ranks=anyRanks.decompose(case, (2, 1, 1)))
    case.file("system/decomposeParDict", "numberOfSubdomains 3; method simple;"
              " simpleCoeffs { n (3 1 1); delta 0.001; }\n")
    case.run("redistributePar", "-overwrite", "-latestTime", ranks=3)
    case.control(endTime=0.04)
    case.run("fsiPisoFoam", ranks=3)
    anyRanks.same(report, "redistributePar", serial, case)


def work(case):
    """Least and most of a rank, and most over the mean, by kind, as the log
    tells."""
    log = results.read(case.path, "log.fsiPisoFoam")
    return {name: tuple(map(float, numbers.split())) for name, numbers in
            re.findall(r"(?m)^ +(cells|nodes|pairs)((?: +\S+){3})$",
                       log[log.find("Work of the ranks"):])}


def check_weights(report, folder):
    """Ranks of equal work: objects in one half of the box."""
    case = fsiCase.Case(
        os.path.join(folder, "weights"), cells=(32, 32),
        shapes="disc { shape { type circle; radius 0.1; }"
               " material { density 1; E 100; } }",
        placements="a { type lattice; shape disc; spacing (0.25 0.25 0);"
                   " region { min (0 0 0); max (0.5 1 0); } }",
        deltaT=0.01, endTime=0.02).set_up()
    case.run("seedObjects", "-weights")
    case.file("system/decomposeParDict",
              "numberOfSubdomains 2; method hierarchical; weightField cellWork;"
              " hierarchicalCoeffs { n (2 1 1); order xyz; delta 0.001; }\n")
    case.run("decomposePar")
    case.run("fsiPisoFoam", ranks=2)
    found = work(case)
    least, most, over = found["cells"]
    report.check("the rank with the objects has less cells",
                 least + most == 32*32 and 256 <= least < 480
                 and abs(over - most/512) < 1e-3, found)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("plane", anyRanks.compare, report, folder, anyRanks.channel,
                   [(1, 3), (4, 1), (3, 2), (5, 1)])
    report.attempt("space", anyRanks.compare, report, folder, anyRanks.box,
                   [(3, 1, 1), (1, 3, 1), (2, 1, 3), "hollow"])
    report.attempt("films", check_film, report, folder)
    report.attempt("weak coupling", check_weak, report, folder)
    report.attempt("restart", check_restart, report, folder)
    report.attempt("redistributed", check_redistributed, report, folder)
    report.attempt("weights", check_weights, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
