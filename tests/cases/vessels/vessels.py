#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects in vessels, whose walls are surfaces from files.

    vessels.py FOLDER

A tube of radius 1 that is cyclic along its axis holds membranes or elastic
bodies. They are seeded in the fluid alone, some of them across the cyclic
sides, and the run is the same on two and three ranks and after a restart.
etc/profiles takes the section of the vessel as the tube. branch.py has the flow
in a duct with a branch.
"""

import filecmp
import math
import os
import re
import subprocess
import sys

import branch
import fsiCase
import results
from tubeFile import write_tube

LENGTH = 4

# The tube ends so far beyond the cyclic sides
BEYOND = 1.6

MATERIALS = {
    "membranes": "type membrane; law neoHookean; shearModulus 60; density 1;",
    "bodies": "density 1; E 1000;",
}

VESSEL = """
vessel
{
    shape    { type surface; file "tube.stl"; inside yes; }
    material { type rigid; density 1; }
    motion   { type fixed; }
}
"""


def tube(folder, name, kind, number, start=0.0, **more):
    """The seeded case."""
    membranes = kind == "membranes"
    case = fsiCase.Case(
        os.path.join(folder, name), cyclic="x", viscosity=20,
        box=(start, -1.125, -1.125, start + LENGTH, 1.125, 1.125),
        cells=(32, 18, 18),
        properties="drivingForce { type meanVelocity; velocity (0.3 0 0); } "
                   "output { objectsEvery 1; } "
                   + ("contact { law { type none; } }" if membranes else ""),
        shapes=VESSEL + "cell { shape { type sphere; radius 0.4; } material "
                        f"{{ {MATERIALS[kind]} }} }}",
        placements="a { type inPlace; shape vessel; } b { type packed; shape "
                   f"cell; number {number}; seed 1; minimumGap 0.1; wallGap 0; "
                   "start small; }",
        **{"deltaT": 0.02, "writePrecision": 17, "timePrecision": 10, **more})
    write_tube(f"{case.path}/tube.stl", 1, start - BEYOND,
               start + LENGTH + BEYOND)
    return case.set_up()


def centres(case):
    """Of the spheres at the first row."""
    rows = results.table(case.path, "objects.csv")
    return [tuple(row[f"centroid{axis}"] for axis in "XYZ") for row in rows
            if row["time"] == rows[0]["time"] and row["object"] > 0]


def check_seeding(report, folder):
    """The spheres are in the tube, and some reach across the cyclic sides,
    wherever the domain begins."""
    for start in (0, -102.3):
        name = f"membranes from {start}"
        case = tube(folder, f"seeded{start}", "membranes", 9, start,
                    endTime=0.4, writeInterval=10, p_tolerance=1e-6)
        text = case.run("fsiPisoFoam")
        places = centres(case)
        report.check(f"{name} are in the tube", len(places) == 9 and max(
            math.hypot(y, z) for _, y, z in places) < 0.6, str(places))
        report.check(f"{name} reach across the cyclic sides", any(
            min(x - start, start + LENGTH - x) < 0.4 for x, _, _ in places),
                     str(places))
        inside = re.findall(r"inside other objects: (\d+) of (\d+)", text)
        report.check(f"{name}: no node is in the wall", len(inside) > 1 and all(
            n == "0" and int(of) > 500 for n, of in inside), str(inside))
        check_profiles(report, name, case)
        report.check(f"{name} are sound", "Objects are sound"
                     in case.run("checkObjects"), "checkObjects")


def check_profiles(report, name, case):
    """Radius and centre of the tube, and the fraction of the membranes. The
    rings of the wall are polygons of 24 corners."""
    command = [os.path.join(os.path.dirname(os.path.abspath(__file__)),
                            "../../../etc/profiles"), case.path]
    text, without = (subprocess.run(
        command + options, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, check=False).stdout
                     for options in (["-tube", "vessel"], []))
    report.check(f"{name}: etc/profiles without the tube", "-tube" in without,
                 without)
    found = re.search(r"R,Y,Z (\S+),(\S+),(\S+)\n", text)
    share = re.search(r"tube haematocrit +(\S+)\n", text)
    area = 12*math.sin(2*math.pi/24)
    rows = results.table(case.path, "objects.csv")
    volume = sum(row["volume"] for row in rows
                 if row["time"] == rows[-1]["time"] and row["object"] > 0)
    report.check(
        f"{name}: etc/profiles", found and share
        and abs(float(found[1])/math.sqrt(area/math.pi) - 1) < 0.01
        and max(abs(float(v)) for v in found.groups()[1:]) < 0.01
        and abs(float(share[1])*LENGTH*area/volume - 1) < 0.02, text)


def check_same(report, folder):
    """Ranks and a restart."""
    for kind, number in (("membranes", 6), ("bodies", 3)):
        short = {"endTime": 0.08, "writeInterval": 2, "p_tolerance": 1e-12,
                 "U_tolerance": 1e-12}
        whole = tube(folder, "whole", kind, number, **short)
        whole.run("fsiPisoFoam")
        parts = tube(folder, "parts", kind, number,
                     **{**short, "endTime": 0.04})
        parts.run("fsiPisoFoam")
        parts.control(startFrom="latestTime", endTime=0.08)
        parts.run("fsiPisoFoam")
        last = results.times(whole.path)[-1]
        differ = [name for name in ("U", "p", "phi", "uniform/fsiObjects/cell")
                  if not filecmp.cmp(os.path.join(whole.path, last, name),
                                     os.path.join(parts.path, last, name),
                                     False)]
        report.check(f"{kind} in a vessel, restart: the same to the last bit",
                     not differ, str(differ))
        for n in (2, 3):
            ranks = tube(folder, "ranks", kind, number, **short)
            ranks.run("fsiPisoFoam", ranks=ranks.decompose(n, 1, 1))
            ranks.run("reconstructPar", "-latestTime")
            apart = results.difference(whole.path, ranks.path)
            report.check(f"{kind} in a vessel on {n} ranks", apart < 1e-7,
                         f"{apart:.2e} of the size")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("seeding in a vessel", check_seeding, report, folder)
    report.attempt("ranks and restart", check_same, report, folder)
    report.attempt("a branch", branch.check, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
