# SPDX-License-Identifier: GPL-3.0-or-later
"""Scalars that the flow carries: the Sherwood number of a sphere of a fixed
value at Re 20 and Pe 20 (Froessling 1938; Clift, Grace and Weber 1978), heat
in and around a disc and a sphere in a gradient (Maxwell), and the Nusselt
number of a square between a hot and a cold wall (de Vahl Davis 1983)."""

from common import FOLDER, Row
from scalarFlows import SHERWOOD, at_rest, nusselt, sherwood


def stream():
    """The sphere in a stream."""
    number, minutes = sherwood(FOLDER)
    for name, value in SHERWOOD.items():
        yield Row(f"sphere in a stream, Sherwood number, {name}", "D/h = 8",
                  value, number, 0.03*value, minutes)


def inside():
    """Errors in and around bodies."""
    for solid, ladder in ((False, (8, 16, 32)), (True, (6, 12))):
        for conductivity in (10, 0.1):
            for n in ladder:
                found = at_rest(FOLDER, n, solid, conductivity)
                what = (f"{'sphere' if solid else 'disc'} that makes heat, "
                        f"conductivity {conductivity}")
                yield Row(f"{what}, root mean square of the error over "
                          "gradient times radius", f"D/h = {n}", 0,
                          found.mean, None, found.minutes, (what, n))
            yield Row(f"{what}, largest error", f"D/h = {n}", 0,
                      found.largest, None, found.minutes)


def cavity():
    """The Nusselt number in the limit of a fine mesh."""
    found = [nusselt(FOLDER, n) for n in (16, 32)]
    (one, _), (two, minutes) = found
    yield Row("square between a hot and a cold wall, Ra 1e4, Nusselt number",
              "h = 1/16, 1/32", 2.243, two + (two - one)/3, 0.01*2.243,
              minutes)


def scalars():
    """All."""
    yield from stream()
    yield from inside()
    yield from cavity()


CASES = {"scalars": scalars}
