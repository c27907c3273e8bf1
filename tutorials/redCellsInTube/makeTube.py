#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the wall of a round tube along x as a closed surface in an STL file: a
thick pipe whose outer side and ends are outside the box.

    makeTube.py FILE
"""

import math
import sys

# Inside the box of 20 x 13.5 x 13.5 micrometres, and beyond its edges [m]
RADII = (6e-6, 11e-6)

# Half the length; the ends are not in the box
HALF_LENGTH = 14e-6

N_AROUND, N_ALONG = 72, 40


def ring(radius, x):
    """Points on a circle about the axis."""
    return [(x, radius*math.cos(a), radius*math.sin(a))
            for a in (2*math.pi*k/N_AROUND for k in range(N_AROUND))]


def strip(one, other):
    """Triangles between two rings."""
    for k in range(N_AROUND):
        a, b = one[k - 1], one[k]
        c, d = other[k - 1], other[k]
        yield a, b, c
        yield b, d, c


def main(path):
    """Along the inner side, back along the outer one, and round the end."""
    places = [HALF_LENGTH*(2*i/N_ALONG - 1) for i in range(N_ALONG + 1)]
    rings = ([ring(RADII[0], x) for x in places]
             + [ring(RADII[1], x) for x in reversed(places)])
    with open(path, "w", encoding="ascii") as stream:
        stream.write("solid tube\n")
        for i, one in enumerate(rings):
            for triangle in strip(one, rings[i - 1]):
                stream.write("facet normal 0 0 0\nouter loop\n")
                for point in triangle:
                    stream.write("vertex {:.9g} {:.9g} {:.9g}\n".format(
                        *point))
                stream.write("endloop\nendfacet\n")
        stream.write("endsolid tube\n")


if __name__ == "__main__":
    main(sys.argv[1])
