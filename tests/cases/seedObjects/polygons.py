#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads VTK PolyData files and measures polygons, with Python alone.

    polygons.py CASE    checks the files that seedObjects wrote for the case

Prints lines "ok NAME" and "FAIL NAME: reason".
"""

import base64
import math
import os
import struct
import sys
import xml.etree.ElementTree as ElementTree

CODES = {"Int32": "i", "Int64": "q", "Float32": "f", "Float64": "d"}


def values(array):
    """The numbers of a DataArray element, in base64."""
    code = CODES[array.get("type")]
    raw = base64.b64decode("".join(array.text.split()), validate=True)
    (n_bytes,) = struct.unpack("<Q", raw[:8])
    if n_bytes != len(raw) - 8:
        raise ValueError(f"{array.get('Name')}: {len(raw) - 8} bytes, "
                         f"not {n_bytes} as it says")
    return list(struct.unpack(f"<{n_bytes//struct.calcsize(code)}{code}",
                              raw[8:]))


def tuples(array):
    """The numbers of a DataArray, grouped by its NumberOfComponents."""
    n = int(array.get("NumberOfComponents", "1"))
    flat = values(array)
    if n == 1:
        return flat
    return [tuple(flat[i:i + n]) for i in range(0, len(flat), n)]


def read(file_name, tag):
    """Points, cells of a tag (Polys, Lines), cell data and point data."""
    root = ElementTree.parse(file_name).getroot()
    if root.tag != "VTKFile" or root.get("type") != "PolyData":
        raise ValueError("not a VTKFile of type PolyData")
    piece = root.find("PolyData/Piece")
    points = tuples(piece.find("Points/DataArray"))
    cells_of = {a.get("Name"): values(a) for a in piece.find(tag)}
    offsets = [0] + cells_of["offsets"]
    cells = [cells_of["connectivity"][a:b]
             for a, b in zip(offsets, offsets[1:])]
    cell_data = {a.get("Name"): tuples(a) for a in piece.find("CellData")}
    point_data = {a.get("Name"): tuples(a) for a in piece.find("PointData")}

    sizes = [("points", len(points), int(piece.get("NumberOfPoints"))),
             ("cells", len(cells), int(piece.get("NumberOf" + tag)))]
    sizes += [(k, len(v), len(cells)) for k, v in cell_data.items()]
    sizes += [(k, len(v), len(points)) for k, v in point_data.items()]
    for name, size, expected in sizes:
        if size != expected:
            raise ValueError(f"{name}: {size} values, not {expected}")
    for cell in cells:
        if min(cell) < 0 or max(cell) >= len(points):
            raise ValueError("a cell has a point that is not there")
    return points, cells, cell_data, point_data


def segment_distance(p, a, b):
    """Distance of a point to a segment."""
    ex, ey = b[0] - a[0], b[1] - a[1]
    dx, dy = p[0] - a[0], p[1] - a[1]
    t = min(max((dx*ex + dy*ey)/(ex*ex + ey*ey), 0), 1)
    return math.hypot(dx - t*ex, dy - t*ey)


def contains(polygon, p):
    """True if a point is in a polygon."""
    inside = False
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]):
            x = a[0] + (p[1] - a[1])*(b[0] - a[0])/(b[1] - a[1])
            inside ^= p[0] < x
    return inside


def polygon_distance(one, other):
    """Distance of two polygons; 0 if a node of one is in the other."""
    if any(contains(one, p) for p in other):
        return 0
    if any(contains(other, p) for p in one):
        return 0
    return min(
        segment_distance(p, a, b)
        for first, second in ((one, other), (other, one))
        for p in first
        for a, b in zip(second, second[1:] + second[:1])
    )


def check_surfaces(case):
    """The set-up of system/seedObjectsDict, from its picture."""
    points, cells, cell_data, point_data = read(
        os.path.join(case, "postProcessing/seedObjects/surfaces.vtp"), "Polys"
    )
    polygons = [[points[i][:2] for i in cell] for cell in cells]
    report("surfaces.vtp is well formed", len(polygons) == 31,
           f"{len(polygons)} polygons, not 31")
    report("ids are the order of the dictionary",
           sorted(cell_data["object"]) == list(range(31)), "other ids")

    flat = [c for p in polygons for q in p for c in q]
    report("all are in the domain", min(flat) > 0 and max(flat) < 1,
           f"coordinates from {min(flat)} to {max(flat)}")

    # By id: listed 0-1, lattice 2-7, csv 8-9, random 10-15, packed 16-
    by_id = dict(zip(cell_data["object"], polygons))
    gaps = {(i, j): polygon_distance(by_id[i], by_id[j])
            for i in range(31) for j in range(i)}
    report("no two overlap", min(gaps.values()) > 0, "a distance is 0")
    loose = min(g for (i, j), g in gaps.items() if 10 <= i <= 15)
    report("random keeps 3 h", loose >= 0.0375 - 1e-6, f"distance {loose}")
    dense = min(g for (i, j), g in gaps.items() if i > 15)
    report("packed keeps minimumGap", dense >= 0.01 - 1e-6, f"distance {dense}")

    velocity = {i: point_data["velocity"][cell[0]]
                for i, cell in zip(cell_data["object"], cells)}
    change = [math.hypot(velocity[i][0], velocity[i][1] - 0.2)
              for i in range(2, 8)]
    report("velocities are perturbed as said",
           0 < max(change) <= 0.02 + 1e-6, f"changes {change}")
    report("a file's velocity is taken", abs(velocity[8][0] - 0.25) < 1e-6,
           f"velocity {velocity[8]}")


def check_springs(case):
    """All springs are there and at rest."""
    _, cells, cell_data, _ = read(
        os.path.join(case, "postProcessing/seedObjects/springs.vtp"), "Lines"
    )
    strain = max(abs(s) for s in cell_data["strain"])
    report("springs.vtp is well formed",
           len(cells) > 31 and all(len(c) == 2 for c in cells), "not lines")
    report("springs are at rest", strain < 1e-5, f"strain {strain}")


def report(name, passed, reason):
    """Prints the outcome of a check."""
    print(f"ok {name}" if passed else f"FAIL {name}: {reason}")


if __name__ == "__main__":
    check_surfaces(sys.argv[1])
    check_springs(sys.argv[1])
