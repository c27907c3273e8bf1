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
5. From nothing, so that neighbour cells are equal: the cuts between three ranks
   change neither the field nor the amount, and no value is negative.
6. Heat moves the fluid: the flow in a square between a hot and a cold wall
   (de Vahl Davis, 1983, doi 10.1002/fld.1650030305).
"""

import math
import os
import sys

import fsiCase
import results
from scalarCase import SIDES, ScalarCase, apart, ball, box, keeps
from scalarFlows import SHERWOOD, nusselt, sherwood


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
    number, _ = sherwood(folder)
    for name, value in SHERWOOD.items():
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


def from_nothing(report, folder):
    """Check 5."""
    cases = []
    for n in (1, 3):
        case = box(folder, f"nothing{n}", values=(0,),
                   surfaces="disc { type fixedValue; value 2; }",
                   U_tolerance=1e-11, endTime=0.03, writeInterval=3)
        case.run("fsiPisoFoam", ranks=case.decompose(1, n))
        if n > 1:
            case.run("reconstructPar", "-latestTime")
        rows = results.table(case.path, "dye.csv")
        lost = abs(rows[-1]["amount"]/(0.01*sum(r["disc"] for r in rows)) - 1)
        report.check(f"from nothing on {n} ranks: amount", lost < 1e-10,
                     f"{lost}")
        least = min(r["least"] for r in rows)
        report.check(f"from nothing on {n} ranks: bounds", least > -1e-11,
                     f"{least}")
        cases.append(case)
    change = apart(*cases, "dye")
    report.check("from nothing: ranks", change < 1e-8, f"{change}")


def buoyancy(report, folder):
    """Check 6."""
    one, two = (nusselt(folder, n)[0] for n in (16, 32))
    limit = two + (two - one)/3
    print(f"    Nusselt number {one:.4f}, {two:.4f}, in the limit "
          f"{limit:.4f}; de Vahl Davis 2.243")
    report.check("Nusselt number", abs(limit/2.243 - 1) < 0.01, f"{limit}")


def main(folder):
    """All checks."""
    report = fsiCase.Report()
    for solid in (False, True):
        report.attempt("blocked", keeps, report, folder, solid)
    report.attempt("fixed value", fixed_value, report, folder)
    report.attempt("stream", stream, report, folder)
    report.attempt("given", given, report, folder)
    report.attempt("from nothing", from_nothing, report, folder)
    report.attempt("buoyancy", buoyancy, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
