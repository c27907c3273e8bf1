# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces as STL."""


def write(path, triangles):
    """triangles: three corners each, counter-clockwise from outside."""
    with open(path, "w", encoding="ascii") as stream:
        stream.write("solid surface\n")
        for corners in triangles:
            stream.write("facet normal 0 0 0\nouter loop\n" + "".join(
                "vertex {:.12g} {:.12g} {:.12g}\n".format(*corner)
                for corner in corners) + "endloop\nendfacet\n")
        stream.write("endsolid surface\n")


def extruded(loops, bottom, top):
    """Triangles of a plane figure that is extruded along z. loops: its convex
    parts, counter-clockwise; where two meet, they share a whole edge."""
    triangles, edges = [], set()
    for loop in loops:
        for i in range(1, len(loop) - 1):
            flat = (loop[0], loop[i], loop[i + 1])
            triangles.append([(*p, top) for p in flat])
            triangles.append([(*p, bottom) for p in reversed(flat)])
        for a, b in zip(loop, loop[1:] + loop[:1]):
            if (b, a) in edges:
                edges.remove((b, a))
            else:
                edges.add((a, b))
    for a, b in sorted(edges):
        triangles += [[(*a, bottom), (*b, bottom), (*b, top)],
                      [(*a, bottom), (*b, top), (*a, top)]]
    return triangles
