# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what fsiPisoFoam wrote: tables, fields, the state of the objects."""

import csv
import glob
import math
import os
import re


# Columns of words
WORDS = ("shape", "patch", "place")


def table(case, name):
    """Rows of postProcessing/fsiObjects/*/NAME as dictionaries of numbers."""
    rows = []
    for path in sorted(
        glob.glob(os.path.join(case, "postProcessing/fsiObjects/*", name)),
        key=lambda p: float(p.split(os.sep)[-2])
    ):
        with open(path, encoding="ascii") as stream:
            for row in csv.DictReader(stream):
                rows.append({k: v if k in WORDS else float(v)
                             for k, v in row.items()})
    if not rows:
        raise ValueError(f"{case} has no {name}")
    return rows


def times(case):
    """Names of the time folders, in order."""
    names = [n for n in os.listdir(case) if re.fullmatch(r"[0-9.e+-]+", n)]
    return sorted(names, key=float)


def numbers(text, key):
    """The list of numbers of an ascii entry; of vectors, all components."""
    match = re.search(
        rf"(?m)^{key}\s+(?:nonuniform\s+)?(?:List<\w+>\s+)?(\d+)\s*"
        r"(?:\{([^}]*)\}|\(([\s\d.eE+()-]*)\)\s*;)", text)
    if match is None:
        raise ValueError(f"no list {key}")
    n, same, values = match.groups()
    if same is not None:
        return [float(same)]*int(n)
    return [float(v) for v in re.sub("[()]", " ", values).split()]


def read(*path):
    """The text of a file."""
    with open(os.path.join(*path), encoding="ascii") as stream:
        return stream.read()


def field(case, time, name):
    """Values of a field of the cells in an ascii file, flat."""
    return numbers(read(case, time, name), "internalField")


def dimensions(case, time, rank=""):
    """Of the objects: 2 or 3."""
    text = read(case, rank, time, "uniform/fsiPopulation")
    return int(re.search(r"nDims\s+(\d)", text).group(1))


def without_sums(text):
    """The text of a state file without its check sum: it may be changed."""
    return re.sub(r"\ncheckSum\s+\w+;", "", text)


def state(case, time, rank=""):
    """Of each object id: shape, and the positions of all nodes, boundary nodes
    first, and the number of boundary nodes; rank is a folder processorN."""
    objects = {}
    folder = os.path.join(case, rank, time, "uniform/fsiObjects")
    n_dims = dimensions(case, time, rank)
    for shape in sorted(os.listdir(folder)):
        text = read(folder, shape)
        ids = [int(i) for i in numbers(text, "objectIds")]
        flat = numbers(text, "positions")
        n = len(flat)//(n_dims*len(ids)) if ids else 0
        definition = read(case, "constant/fsiObjects", shape)
        n_boundary = int(re.search(r"nBoundaryNodes\s+(\d+)",
                                   definition).group(1))
        for copy, number in enumerate(ids):
            columns = (flat[n*i:n*(i + 1)]
                       for i in range(n_dims*copy, n_dims*(copy + 1)))
            objects[number] = (shape, list(zip(*columns)), n_boundary)
    return objects


def difference(case, other, ranks=("", "")):
    """Largest distance of nodes at the last times of two cases, over an
    object's size; ranks: folders processorN of them."""
    one, two = (state(c, times(os.path.join(c, r))[-1], r)
                for c, r in zip((case, other), ranks))
    if sorted(one) != sorted(two):
        raise ValueError(f"objects {sorted(two)}, not {sorted(one)}")
    worst = 0
    for number, (_, nodes, _) in one.items():
        size = max(max(c) - min(c) for c in zip(*nodes))
        worst = max(worst, *(math.dist(a, b)/size for a, b
                             in zip(nodes, two[number][1])))
    return worst


def outlines(case, time, rank=""):
    """The polygon of each object id, counter-clockwise."""
    return {i: points[:n]
            for i, (_, points, n) in state(case, time, rank).items()}


def centroid(polygon):
    """Centroid of a polygon."""
    # About a node, against cancellation
    x0, y0 = polygon[0]
    area = sx = sy = 0
    for (ax, ay), (bx, by) in edges(polygon):
        cross = (ax - x0)*(by - y0) - (bx - x0)*(ay - y0)
        area += cross
        sx += (ax + bx - 2*x0)*cross
        sy += (ay + by - 2*y0)*cross
    return x0 + sx/(3*area), y0 + sy/(3*area)


def area(polygon):
    """Area of a polygon, > 0 if it is counter-clockwise."""
    x0, y0 = polygon[0]
    return sum((ax - x0)*(by - y0) - (bx - x0)*(ay - y0)
               for (ax, ay), (bx, by) in edges(polygon))/2


def edges(polygon):
    """Pairs of neighbouring points."""
    return zip(polygon, polygon[1:] + polygon[:1])
