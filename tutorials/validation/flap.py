# SPDX-License-Identifier: GPL-3.0-or-later
"""The flap of Turek and Hron (2006) alone, without a fluid: a bar, 0.35 x 0.02,
that a cylinder of the radius 0.05 holds, under gravity 2 (tests CSM 1 to 3).

St. Venant and Kirchhoff's material, plane strain, with Poisson's ratio 0.4.
Here it is neoHookean with the same moduli in the plane, for the shear modulus
G: E = 10 G/3, bulk modulus 5 G, which is half the entry areaStiffness. Strains
are below 1 %, so that the two materials hardly differ. Nodes in the cylinder
are clamped, and those of the outline at x = 0.25, just outside.
"""

import math

import results
from common import Case, Row

HALF_WIDTH, LEFT, RIGHT, MIDDLE = 0.01, 0.16, 0.6, 0.2


def flap(name, across, shear, scheme, **controls):
    """The bar, with so many cells across it."""
    h = 2*HALF_WIDTH/across
    cells = tuple(round(x/h) for x in (0.64, 0.32))
    case = Case(
        f"flap-{name}-{across}", box=(0.04, 0.04, 0.68, 0.36), cells=cells,
        density=1e-9, gravity="(0 -2 0)", properties="coupling { type none; }",
        shapes=bar("flap", shear, 0.0511),
        placements="flap { type inPlace; shape flap; }",
        time_scheme=scheme, writeInterval=0.02, **controls)
    corners = ((LEFT, -1), (RIGHT, -1), (RIGHT, 1), (LEFT, 1))
    case.text("constant/flap.csv", "".join(
        f"{x} {MIDDLE + side*HALF_WIDTH}\n" for x, side in corners))
    return case


def bar(name, shear, root):
    """The shape, whose outline is in constant/NAME.csv; root: radius of the
    sphere about (0.2, 0.2) that holds it."""
    return f"""{name}
        {{
            shape    {{ type polygon; file "constant/{name}.csv"; }}
            material {{ type neoHookean; density 1000; E {10/3*shear!r};
                        areaStiffness {10*shear!r}; strain smoothed; }}
            hold     {{ root {{ type sphere; centre (0.2 0.2 0);
                        radius {root!r}; }} }}
        }}"""


def free_end(case, name):
    """Displacement of the middle of the free end, at each written time."""
    moves, start, node = [], None, 0
    for time in results.times(case.path):
        flat = results.numbers(results.read(
            case.path, time, f"uniform/fsiObjects/{name}"), "positions")
        n = len(flat)//2
        if start is None:
            start = flat
            node = min(range(n), key=lambda i: math.hypot(
                flat[i] - RIGHT, flat[n + i] - MIDDLE))
        moves.append((flat[node] - start[node],
                      flat[n + node] - start[n + node]))
    return moves


def csm(number, across, shear, reference):
    """The bar at rest. Euler's rule damps it."""
    case = flap(f"csm{number}", across, shear, "Euler", deltaT=0.02,
                endTime=12)
    minutes = case.solve()
    last = free_end(case, "flap")[-1]
    for what, value, exact in zip(("x", "y"), last, reference):
        yield Row(f"flap under gravity (CSM {number}), displacement of its end "
                  f"in {what}", f"{across} cells across", exact, value,
                  0.03*abs(exact), minutes)


def csm3(across):
    """The bar swings for four periods; mean and amplitude of the third."""
    period = 1/1.0995
    case = flap("csm3", across, 0.5e6, "backward", deltaT=0.005,
                endTime=round(3*period, 2))
    minutes = case.solve()
    moves = free_end(case, "flap")[-round(2*period/0.02):]
    for what, place, mean, amplitude in (("x", 0, -0.014305, 0.014305),
                                         ("y", 1, -0.063607, 0.065160)):
        values = [move[place] for move in moves]
        for name, exact, value in (
                ("mean", mean, (max(values) + min(values))/2),
                ("amplitude", amplitude, (max(values) - min(values))/2)):
            yield Row(f"flap that swings (CSM 3), {name} of the displacement "
                      f"in {what}", f"{across} cells across", exact, value,
                      0.03*abs(exact), minutes)


def still(across=8):
    """All three tests."""
    yield from csm(1, across, 0.5e6, (-7.187e-3, -66.10e-3))
    yield from csm(2, across, 2e6, (-0.4690e-3, -16.97e-3))
    yield from csm3(across)


CASES = {"flap": still}
