# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a vessel that forks as STL: makeVessel.py FILE

It is a plane figure, extruded along z. Its ends are outside the box of the
mesh.
"""

import sys

TRUNK = [(-0.5, -0.4), (1, -0.4), (1, 0.4), (-0.5, 0.4)]
MIDDLE = [(1, -0.4), (1.5, 0), (1, 0.4)]
UPPER = [(1, 0.4), (1.5, 0), (3.8, 0.51), (3.8, 1.24)]
LOWER = [(x, -y) for x, y in UPPER[::-1]]
BOTTOM, TOP = 0.103, 0.897


def main(path):
    """Caps from the parts, and a wall at each edge that only one has."""
    triangles, edges = [], set()
    for loop in (TRUNK, MIDDLE, UPPER, LOWER):
        for i in range(1, len(loop) - 1):
            flat = (loop[0], loop[i], loop[i + 1])
            triangles.append([(*p, TOP) for p in flat])
            triangles.append([(*p, BOTTOM) for p in reversed(flat)])
        for a, b in zip(loop, loop[1:] + loop[:1]):
            if (b, a) in edges:
                edges.remove((b, a))
            else:
                edges.add((a, b))
    for a, b in sorted(edges):
        triangles += [[(*a, BOTTOM), (*b, BOTTOM), (*b, TOP)],
                      [(*a, BOTTOM), (*b, TOP), (*a, TOP)]]
    with open(path, "w", encoding="ascii") as stream:
        stream.write("solid vessel\n")
        for corners in triangles:
            stream.write("facet normal 0 0 0\nouter loop\n" + "".join(
                "vertex {:.9g} {:.9g} {:.9g}\n".format(*corner)
                for corner in corners) + "endloop\nendfacet\n")
        stream.write("endsolid vessel\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
