#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scalars that the flow carries past bodies.

    scalars.py FOLDER

1. Bodies that move and that block the scalar keep its amount to round-off, and
   a uniform scalar stays uniform; in two and three dimensions, on one, two and
   three ranks, and after a restart.
2. A disc and a sphere of a fixed value in a fluid at rest give off what the
   exact solution says, with an error of second order in the mesh.
3. A sphere of a fixed value in a stream at Re 20 and Pe 20 has the Sherwood
   number of Froessling (1938), 2 + 0.552 Re^1/2 Sc^1/3, and of Clift, Grace
   and Weber (1978), 1 + (1 + Pe)^1/3 Re^0.077, within 3 %.
4. The amount in the fluid changes by what surfaces give it, also where they
   move: a disc of a fixed value, an ellipse with a flux.
5. Heat moves the fluid: the flow in a square between a hot and a cold wall
   (de Vahl Davis, 1983, doi 10.1002/fld.1650030305).
"""

import math
import os
import sys

import fsiCase
import results
from scalarCase import SIDES, ScalarCase

STEPS = 30

PLANE = """
disc
{
    shape    { type circle; radius 0.15; }
    material { type rigid; density 3; }
}
bar
{
    shape    { type ellipse; semiAxes (0.12 0.24); }
    material { density 2; E 50; }
}
"""

SOLID = """
disc
{
    shape    { type sphere; radius 0.2; }
    material { type rigid; density 3; }
}
bar
{
    shape    { type ellipsoid; semiAxes (0.12 0.24 0.15); }
    material { density 2; E 50; }
}
"""


def steps_of(n, *values):
    """A nonuniform list: the values in turn, in equal parts of n cells."""
    size = -(-n//len(values))
    text = " ".join(str(values[i//size]) for i in range(n))
    return f"nonuniform List<scalar> {n} ({text})"


def box(folder, name, solid=False, surfaces="", **changes):
    """Bodies that fall and bend in a closed box with a lid that moves, with a
    scalar that differs and a uniform one."""
    cells = (24, 16, 16) if solid else (48, 32)
    n = cells[0]*cells[1]*(cells[2] if solid else 1)
    z = 0.5 if solid else 0
    return ScalarCase(
        os.path.join(folder, name),
        (("dye", f"diffusivity 1e-3; surfaces {{ {surfaces} }}",
          steps_of(n, 1, 0, 2, 0.5), {}),
         ("even", "diffusivity 1e-3;", "uniform 3", {})),
        box=(0, 0, 0, 1.5, 1, 1) if solid else (0, 0, 1.5, 1), cells=cells,
        viscosity=0.01, p_tolerance=1e-10, walls={"top": "(1 0 0)"},
        gravity="(0 -5 0)", shapes=SOLID if solid else PLANE,
        placements=f"""
        a {{ type listed; shape disc; objects ({{ centre (0.4 0.6 {z}); }}); }}
        b {{ type listed; shape bar; objects ({{ centre (1 0.5 {z}); }}); }}
        """, **{
            "deltaT": 0.01, "endTime": 0.01*STEPS, "writeInterval": STEPS//2,
            "writePrecision": 17, **changes}).set_up()


def amount(case, time, name):
    """The sum of C times the volume that cells hold, exactly rounded."""
    return math.fsum(c*w for c, w in zip(
        results.field(case.path, time, name),
        results.field(case.path, time, name + "Volume")))


def apart(case, other, name):
    """The largest difference of a field at the end of two runs."""
    time = results.times(case.path)[-1]
    return max(abs(a - b) for a, b in zip(
        results.field(case.path, time, name),
        results.field(other.path, time, name)))


def blocked(report, folder, solid):
    """Check 1."""
    name = "solid" if solid else "plane"
    case = box(folder, name, solid)
    case.run("fsiPisoFoam")
    half, end = results.times(case.path)[1:]
    row = results.table(case.path, "dye.csv")
    print(f"    {name}: {row[-1]}")
    for scalar in ("dye", "even"):
        kept = abs(amount(case, end, scalar)/amount(case, half, scalar) - 1)
        print(f"    {name}: amount of {scalar} changes by {kept:.1e}")
        report.check(f"{name}: amount of {scalar}", kept < 1e-13, f"{kept}")
    table = abs(row[0]["amount"]/row[-1]["amount"] - 1)
    report.check(f"{name}: amount from the first step on", table < 1e-11,
                 f"{table}")
    uneven = max(abs(c/3 - 1) for c in results.field(case.path, end, "even"))
    report.check(f"{name}: uniform stays so", uneven < 1e-11, f"{uneven}")
    outside = max(-min(r["least"] for r in row),
                  max(r["largest"] for r in row) - 2)
    report.check(f"{name}: bounds", outside < 1e-11, f"{outside}")
    moved = case_moves(case)
    report.check(f"{name}: bodies move by a cell", moved > 1, f"{moved}")

    other = box(folder, name + "Restart", solid, endTime=float(half))
    other.run("fsiPisoFoam")
    other.control(endTime=0.01*STEPS, startFrom="latestTime")
    other.run("fsiPisoFoam")
    change = apart(case, other, "dye")
    report.check(f"{name}: restart", change == 0, f"{change}")
    for n in (2, 3):
        other = box(folder, f"{name}{n}", solid)
        other.run("fsiPisoFoam", ranks=other.decompose(n, 1))
        other.run("reconstructPar", "-latestTime")
        change = apart(case, other, "dye")
        print(f"    {name} on {n} ranks: {change:.1e} apart")
        report.check(f"{name} on {n} ranks", change < 1e-6, f"{change}")


def ball(solid, radius=0.25):
    """Shape and placement of a fixed disc or sphere."""
    shape = "sphere" if solid else "circle"
    return {"shapes": f"disc {{ shape {{ type {shape}; radius {radius}; }} "
                      "material { type rigid; density 1; } "
                      "motion { type fixed; } }",
            "placements": "a { type listed; shape disc; "
                          "objects ({ centre (0 0 0); }); }"}


def still(folder, n, solid):
    """Rate over the exact rate, and the largest error of the field, of a disc
    or sphere of the value 1 with n cells to the diameter, in a fluid at rest.
    The sides of the box have the values of the exact solution."""
    half, radius = (0.75 if solid else 1), 0.25
    cells = round(half/radius*n)
    h = 2*half/cells
    x = [-half + (i + 0.5)*h for i in range(cells)]

    def exact(r):
        return radius/r if solid else math.log(r)/math.log(radius)

    values = " ".join(f"{exact(math.hypot(half, a, b)):.15g}"
                      for b in (x if solid else (0,)) for a in x)
    side = ("type fixedValue; value nonuniform List<scalar> "
            f"{cells**(2 if solid else 1)} ({values});")
    n_dims = 3 if solid else 2
    case = ScalarCase(
        os.path.join(folder, f"still{n_dims}{n}"),
        (("dye", "diffusivity 1; surfaces { disc { type fixedValue; value 1; "
          "} }", "uniform 0", dict.fromkeys(SIDES, side)),),
        box=(-half,)*n_dims + (half,)*n_dims, cells=(cells,)*n_dims,
        viscosity=1, deltaT=1e6, endTime=3e6, writeInterval=3,
        **ball(solid)).set_up()
    case.run("fsiPisoFoam")
    rate = results.table(case.path, "dye.csv")[-1]["disc"]
    error = 0
    for i, value in enumerate(results.field(
            case.path, results.times(case.path)[-1], "dye")):
        r = math.hypot(x[i % cells], x[i//cells % cells],
                       x[i//cells**2] if solid else 0)
        error = max(error, abs(value - exact(r)) if r > radius else 0)
    ideal = (4*math.pi*radius if solid
             else 2*math.pi*h/math.log(1/radius))
    return rate/ideal, error


def fixed_value(report, folder):
    """Check 2."""
    for solid, coarse, fine in ((False, 8, 16), (True, 6, 12)):
        dims = "3D" if solid else "2D"
        one, two = (still(folder, n, solid) for n in (coarse, fine))
        print(f"    {dims}: rates over the exact one {one[0]:.5f}, "
              f"{two[0]:.5f}; largest errors {one[1]:.5f}, {two[1]:.5f}")
        report.check(f"{dims}: rate", abs(two[0] - 1) < 0.01, f"{two[0]}")
        # Second order: a quarter
        report.check(f"{dims}: order of the rate",
                     abs(two[0] - 1) < 0.42*abs(one[0] - 1), f"{one}, {two}")
        report.check(f"{dims}: order of the field", two[1] < 0.42*one[1],
                     f"{one}, {two}")


def stream(report, folder):
    """Check 3."""
    n, reach = 8, 3.5
    case = ScalarCase(
        os.path.join(folder, "stream"),
        (("dye", "diffusivity 0.05; surfaces { disc { type fixedValue; "
          "value 1; } }", "uniform 0",
          {"left": "type fixedValue; value uniform 0;"}),),
        box=(-reach,)*3 + (reach,)*3, cells=(round(2*reach*n),)*3,
        viscosity=0.05, velocity="(1 0 0)",
        walls=dict.fromkeys(SIDES[2:], "(1 0 0)"),
        open={"left": ("type fixedValue; value uniform (1 0 0);",
                       "type zeroGradient;"),
              "right": ("type zeroGradient;",
                        "type fixedValue; value uniform 0;")},
        deltaT=1/n, endTime=7, writeInterval=7*n,
        **ball(True, radius=0.5)).set_up()
    case.run("fsiPisoFoam")
    rate = results.table(case.path, "dye.csv")[-1]["disc"]
    number = rate/(0.05*math.pi)
    for name, value in (("Froessling", 2 + 0.552*20**0.5),
                        ("Clift", 1 + 21**(1/3)*20**0.077)):
        print(f"    Sherwood number {number:.3f}, {name} {value:.3f}")
        report.check(f"Sherwood number, {name}", abs(number/value - 1) < 0.03,
                     f"{number}, {value}")


def given(report, folder):
    """Check 4."""
    case = box(folder, "given", surfaces="disc { type fixedValue; value 2; } "
               "bar { type flux; flux 0.5; }")
    case.run("fsiPisoFoam")
    rows = results.table(case.path, "dye.csv")
    worst = max(abs(b["amount"] - a["amount"] - 0.01*(b["disc"] + b["bar"]))
                for a, b in zip(rows, rows[1:]))/rows[0]["amount"]
    report.check("amounts from surfaces", worst < 1e-11, f"{worst}")
    # Circumference of the ellipse, by Ramanujan's formula, times the depth
    a, b = 0.12, 0.24
    ideal = 0.5*1/32*math.pi*(3*(a + b) - math.sqrt((3*a + b)*(a + 3*b)))
    print(f"    flux over the exact one: {rows[0]['bar']/ideal:.4f}")
    report.check("flux", abs(rows[0]["bar"]/ideal - 1) < 0.02,
                 f"{rows[0]['bar']}, {ideal}")
    report.check("bounds", all(r["least"] > -1e-11 for r in rows),
                 f"{min(r['least'] for r in rows)}")


def cavity(folder, n):
    """Nusselt number of a square of n x n cells at the Rayleigh number 1e4."""
    viscosity = math.sqrt(0.71/1e4)
    case = ScalarCase(
        os.path.join(folder, f"cavity{n}"),
        (("T", f"diffusivity {viscosity/0.71}; "
          "buoyancy { expansion 1; reference 0.5; }", "uniform 0.5",
          {"left": "type fixedValue; value uniform 1;",
           "right": "type fixedValue; value uniform 0;"}),),
        cells=(n, n), viscosity=viscosity, gravity="(0 -1 0)",
        deltaT=0.5/n, endTime=60, writeInterval=120*n).set_up()
    case.run("fsiPisoFoam")
    T = results.field(case.path, results.times(case.path)[-1], "T")
    return sum(2*(1 - T[j*n]) for j in range(n))


def buoyancy(report, folder):
    """Check 5."""
    one, two = (cavity(folder, n) for n in (16, 32))
    limit = two + (two - one)/3
    print(f"    Nusselt number {one:.4f}, {two:.4f}, in the limit "
          f"{limit:.4f}; de Vahl Davis 2.243")
    report.check("Nusselt number", abs(limit/2.243 - 1) < 0.01, f"{limit}")


def case_moves(case):
    """How far an object's node moves, in cells."""
    first, *_, last = results.times(case.path)
    one, two = (results.state(case.path, t) for t in (first, last))
    h = case.values["box"][case.dimensions()]/case.values["cells"][0]
    return max(math.dist(a, b)/h for i in one
               for a, b in zip(one[i][1], two[i][1]))


def main(folder):
    """All checks."""
    report = fsiCase.Report()
    for solid in (False, True):
        report.attempt("blocked", blocked, report, folder, solid)
    report.attempt("fixed value", fixed_value, report, folder)
    report.attempt("stream", stream, report, folder)
    report.attempt("given", given, report, folder)
    report.attempt("buoyancy", buoyancy, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
