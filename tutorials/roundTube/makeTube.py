#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the wall of a round tube along x as a closed surface in an STL file: a
thick pipe whose outer side and ends are outside the box.

    makeTube.py FILE INNER OUTER HALF_LENGTH N_AROUND N_ALONG

INNER, OUTER: radii, inside the box and beyond its edges [m]; HALF_LENGTH: the
ends must not be in the box [m]; N_AROUND, N_ALONG: numbers of faces.
"""

import math
import sys

import stlFile


def ring(radius, x, n):
    """Points on a circle about the axis."""
    return [(x, radius*math.cos(a), radius*math.sin(a))
            for a in (2*math.pi*k/n for k in range(n))]


def strip(one, other):
    """Triangles between two rings."""
    for k in range(len(one)):
        a, b = one[k - 1], one[k]
        c, d = other[k - 1], other[k]
        yield a, b, c
        yield b, d, c


def main(path, inner, outer, half_length, n_around, n_along):
    """Along the inner side, back along the outer one, and round the end."""
    places = [half_length*(2*i/n_along - 1) for i in range(n_along + 1)]
    rings = ([ring(inner, x, n_around) for x in places]
             + [ring(outer, x, n_around) for x in reversed(places)])
    stlFile.write(path, (triangle for i, one in enumerate(rings)
                         for triangle in strip(one, rings[i - 1])))


if __name__ == "__main__":
    main(sys.argv[1], *map(float, sys.argv[2:5]), *map(int, sys.argv[5:7]))
