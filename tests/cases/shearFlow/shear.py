#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Free objects in simple shear turn as theory says: a disc with half the shear
rate, a stiff ellipse and a spheroid of the ratio 3 as Jeffery's, membranes as
Keller and Skalak's.

    shear.py FOLDER
"""

import math
import os
import sys

import fsiCase
import results

TUTORIAL = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "../../../tutorials/membranes")
sys.path.append(TUTORIAL)
import angles  # noqa: E402

# Walls at five radii, copies of the box and Re = 0.1 change rates by some per
# cent, 6.8 cells across the short axis by some more
TOLERANCE = 0.08
DEGREES = 3

STIFF = """
shapes
{
    disc
    {
        shape       { type circle; radius 0.1; }
        material    { density 1000; E 1e5; }
    }
    ellipse
    {
        shape       { type ellipse; semiAxes (0.1414 0.0707); }
        material    { density 1000; E 1e5; }
    }
}
placements
{
    left
    {
        type        listed;
        shape       disc;
        objects     ( { centre (0.5 0.5 0); } );
    }
    right
    {
        type        listed;
        shape       ellipse;
        objects     ( { centre (1.5 0.5 0); } );
    }
}
"""


def solve(path, end, objects=None):
    """Runs the tutorial's box to a time, with other objects if they are given;
    rows of objects.csv by shape."""
    fsiCase.copy(TUTORIAL, path)
    fsiCase.set_entry(os.path.join(path, "system/controlDict"), "endTime", end)
    if objects:
        name = os.path.join(path, "system/seedObjectsDict")
        with open(name, encoding="ascii") as stream:
            header = stream.read().split("}", 1)[0] + "}\n"
        with open(name, "w", encoding="ascii") as stream:
            stream.write(header + objects)

    fsiCase.run(path, "blockMesh")
    fsiCase.run(path, "seedObjects")
    fsiCase.run(path, "fsiPisoFoam", limit=2000)
    cells = {}
    for row in results.table(path, "objects.csv"):
        cells.setdefault(row["shape"], []).append(row)
    return cells


def check_stiff(report, cells):
    """Rates of the disc and of the ellipse, once the flow is steady."""
    rate = -cells["disc"][-1]["angularVelocityZ"]/angles.SHEAR
    print(f"    disc turns with {rate:.4f} of the shear rate")
    report.check("a disc turns with half the shear rate",
                 abs(rate/0.5 - 1) < TOLERANCE, f"{rate}")

    strength = angles.theory(math.inf)[0]
    worst = 0
    for row in cells["ellipse"]:
        if row["time"] < 2:
            continue
        jeffery = 0.5*angles.SHEAR*(
            strength*math.cos(2*row["inclination"]) - 1)
        worst = max(worst, abs(row["angularVelocityZ"] - jeffery))
    print(f"    ellipse: rate off by {worst:.4f} of the shear rate at most")
    report.check("an ellipse turns as Jeffery's", worst < 0.5*TOLERANCE,
                 f"{worst}")


def check_membranes(report, cells):
    """One tank-treads at a steady angle, the other tumbles."""
    rows = cells["equalViscosity"]
    strength, tread = angles.theory(1)
    expected = math.degrees(0.5*math.acos(1/strength))
    angle = math.degrees(rows[-1]["inclination"])
    before = math.degrees(rows[-8]["inclination"])
    print(f"    inclination {angle:.2f}, theory {expected:.2f} degrees")
    report.check("the angle of tank-treading", abs(angle - expected) < DEGREES,
                 f"{angle}, theory {expected}")
    report.check("is steady", abs(angle - before) < 1, f"{before} to {angle}")

    phase = angles.unwrapped([r["phase"] for r in rows], 2*math.pi)
    report.check("the membrane moves on",
                 phase[-1] < -90*tread/strength, f"{phase[-1]}")

    turned = angles.unwrapped([r["inclination"] for r in cells["viscous"]],
                              math.pi)
    report.check("a viscous one tumbles", turned[-1] < -180, f"{turned[-1]}")

    for name, cell in cells.items():
        change = max(abs(r["area"]/cell[0]["area"] - 1) for r in cell)
        report.check(f"area of {name}", change < 1e-10, f"{change}")


def sheared(folder, name, parts=()):
    """Rows of rheology.csv of two rigid discs in a shear box, and the sum of
    their stresslets over the volume of the box, on ranks if parts are given."""
    case = fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 2, 1), cells=(48, 24),
        viscosity=5, cyclic="x", walls={"top": "(0.5 0 0)",
                                        "bottom": "(-0.5 0 0)"},
        shapes="disc { shape { type circle; radius 0.2; } "
               "material { type rigid; density 1; } }",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.6 0.5 0); } { centre (1.4 0.46 0); }); }",
        properties="output { rheology yes; }", deltaT=0.005, endTime=0.3,
        writeInterval=60, p_tolerance=1e-9, U_tolerance=1e-10).set_up()
    case.run("fsiPisoFoam", ranks=case.decompose(*parts) if parts else 1)
    stresslets = [row["stressletXY"]
                  for row in results.table(case.path, "objects.csv")]
    return (results.table(case.path, "rheology.csv"),
            sum(stresslets)/(2/24))


def check_spheroid(report, folder):
    """A spheroid with 8 cells to its long half-axis, 2.7 to the short one,
    turns slowest where it lies along the flow."""
    h, step = 1/8, 30/64
    shear = 1e-3/step
    wall = shear*2.5
    for degrees in (0, 90):
        angle = math.radians(degrees)/2
        case = fsiCase.Case(
            os.path.join(folder, "spheroid"), box=(0, 0, 0, 6, 5, 4),
            cells=(48, 40, 32), viscosity=1, cyclic="xz",
            walls={"top": f"({wall} 0 0)", "bottom": f"({-wall} 0 0)"},
            shapes="a { shape { type ellipsoid; semiAxes (1 0.3333333 "
                   "0.3333333); } material { type rigid; density 1; } "
                   "minimumCells 5; }",
            placements="a { type listed; shape a; objects ({ centre "
                       f"({3 + 0.3*h} {2.5 + 0.2*h} {2 + 0.1*h}); rotation "
                       f"{{ quaternion ({math.cos(angle)} (0 0 "
                       f"{math.sin(angle)})); }} }}); }}",
            deltaT=step, endTime=30*step, writeInterval=30).set_up()
        case.run("fsiPisoFoam")
        rate = -results.table(case.path, "objects.csv")[-1][
            "angularVelocityZ"]/shear
        jeffery = 0.9 if degrees else 0.1
        print(f"    spheroid at {degrees} degrees: {rate:.4f} of the shear "
              f"rate, Jeffery {jeffery}")
        report.check(f"a spheroid at {degrees} degrees",
                     abs(rate - jeffery) < 0.1*jeffery, f"{rate}")


def check_rheology(report, folder):
    """The stress of the walls and that of fluid and bodies agree."""
    rows, stresslets = sheared(folder, "rheology")
    last = rows[-1]
    apart = abs(last["viscosity"]/last["wallViscosity"] - 1)
    print(f"    viscosity {last['wallViscosity']:.4f} by the walls, "
          f"{last['viscosity']:.4f} by the parts of the stress")
    report.check("walls and bodies give the same viscosity",
                 last["wallViscosity"] > 1.2 and apart < 0.03, f"{last}")
    report.check("stresslets of the objects are the objects' stress",
                 abs(stresslets - last["objectStress"])
                 < 1e-6*abs(stresslets), f"{stresslets}, {last}")
    other = sheared(folder, "rheologyRanks", (3, 1))[0][-1]
    worst = max(abs(other[key] - last[key]) for key in last)
    report.check("rheology on three ranks", worst < 1e-6, f"{worst}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    cells = report.attempt("stiff objects", solve,
                           os.path.join(folder, "stiff"), 5, STIFF)
    if cells:
        check_stiff(report, cells)
    cells = report.attempt("membranes", solve,
                           os.path.join(folder, "membranes"), 11)
    if cells:
        check_membranes(report, cells)
    report.attempt("spheroid", check_spheroid, report, folder)
    report.attempt("rheology", check_rheology, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
