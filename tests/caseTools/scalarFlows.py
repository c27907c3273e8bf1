# SPDX-License-Identifier: GPL-3.0-or-later
"""Scalars past, in and without bodies, with a known result: a sphere in a
stream, a body in a gradient, a square between a hot and a cold wall."""

import collections
import math
import os

import results
from scalarCase import SIDES, ScalarCase, ball

# Of a sphere at Re 20 and Pe 20: 2 + 0.552 Re^1/2 Sc^1/3, and
# 1 + (1 + Pe)^1/3 Re^0.077
SHERWOOD = {"Froessling": 2 + 0.552*20**0.5, "Clift": 1 + 21**(1/3)*20**0.077}

# Errors of the field over gradient times radius, rate that comes out over the
# exact one
AtRest = collections.namedtuple("AtRest", "largest mean rate minutes")


def places(n, half):
    """Centres of cells along an axis."""
    return [-half + (i + 0.5)*2*half/n for i in range(n)]


def sherwood(folder, n=8):
    """Sherwood number of a sphere of a fixed value with n cells to the
    diameter, at Re 20 and Pe 20, and minutes."""
    reach = 3.5
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
    return rate/(0.05*math.pi), case.seconds["fsiPisoFoam"]/60


def at_rest(folder, n, solid, conductivity):
    """A disc or a sphere of the partition coefficient 2 that makes heat, with a
    gradient of 1 across it and n cells to the diameter; conductivity: over the
    fluid's. The exact solution is Maxwell's plus that of a
    source; the sides of the box have its values."""
    half, radius, partition, source = (0.75 if solid else 1), 0.25, 2, 8
    cells = round(half/radius*n)
    axis = places(cells, half)
    d = 3 if solid else 2
    dipole = (1 - conductivity)/(d - 1 + conductivity)
    made = source*radius**2/d

    def exact(*place):
        r = math.hypot(*place)
        if r < radius:
            return (d/(d - 1 + conductivity)*place[0]
                    + source*(radius**2 - r*r)/(2*d*conductivity)
                    + (made if solid else made*math.log(1/radius)))
        return (place[0]*(1 + dipole*(radius/r)**d)
                + (made*radius/r if solid else made*math.log(1/r)))

    # The same as a formula of a place outside
    r = "sqrt(" + " + ".join(f"sqr(pos().{x}())" for x in "xyz"[:d]) + ")"
    rest = (f"{made*radius:.15g}/{r}" if solid
            else f"{-made:.15g}*log({r})")
    side = ("type exprFixedValue; value uniform 0; valueExpr "
            f'"pos().x()*(1 + {dipole*radius**d:.15g}/pow({r}, {d})) '
            f'+ {rest}";')
    case = ScalarCase(
        os.path.join(folder, f"rest{d}D{n}x{conductivity}"),
        (("dye", "diffusivity 1; surfaces { disc { type permeable; partition "
          f"{partition}; diffusivity {conductivity/partition}; source "
          f"{source}; }} }}", "uniform 0", dict.fromkeys(SIDES, side)),),
        box=(-half,)*d + (half,)*d, cells=(cells,)*d, viscosity=1,
        deltaT=10, endTime=400, writeInterval=40, **ball(solid)).set_up()
    case.run("fsiPisoFoam")
    values = results.field(case.path, results.times(case.path)[-1], "dye")
    errors = [abs(c - exact(*(axis[i//cells**k % cells] for k in range(d))))
              /radius for i, c in enumerate(values)]
    row = results.table(case.path, "dye.csv")[-1]
    depth = 1 if solid else 2*half/cells
    made = source*(4/3*math.pi*radius**3 if solid else math.pi*radius**2*depth)
    return AtRest(max(errors),
                  math.sqrt(sum(e*e for e in errors)/len(errors)),
                  row["disc"]/made, case.seconds["fsiPisoFoam"]/60)


def nusselt(folder, n):
    """Nusselt number of a square of n x n cells at the Rayleigh number 1e4 and
    the Prandtl number 0.71, and minutes."""
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
    return (sum(2*(1 - T[j*n]) for j in range(n)),
            case.seconds["fsiPisoFoam"]/60)
