#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a body with three round lobes as an STL file, in millimetres as CAD
programs do. Put a surface of your own in its place.

    makeBody.py FILE
"""

import math
import sys

# Mean radius in millimetres, and how far the lobes reach out
RADIUS, LOBES = 140, 0.35

N = 24


def point(i, j):
    """The surface at a latitude i of N and a longitude j of 2 N."""
    latitude, longitude = math.pi*i/N, math.pi*j/N
    across = math.sin(latitude)
    r = RADIUS*(1 + LOBES*across**3*math.cos(3*longitude))
    return (r*across*math.cos(longitude), r*across*math.sin(longitude),
            0.8*r*math.cos(latitude))


def triangles():
    """All of them, seen from outside counter-clockwise."""
    for i in range(N):
        for j in range(2*N):
            a, b = point(i, j), point(i, (j + 1) % (2*N))
            c, d = point(i + 1, j), point(i + 1, (j + 1) % (2*N))
            # No triangles without an area at the poles
            if i > 0:
                yield a, c, b
            if i < N - 1:
                yield b, c, d


def main(path):
    """The STL file."""
    with open(path, "w", encoding="ascii") as stream:
        stream.write("solid body\n")
        for triangle in triangles():
            stream.write("facet normal 0 0 0\nouter loop\n")
            for corner in triangle:
                stream.write("vertex {:.7g} {:.7g} {:.7g}\n".format(*corner))
            stream.write("endloop\nendfacet\n")
        stream.write("endsolid body\n")


if __name__ == "__main__":
    main(sys.argv[1])
