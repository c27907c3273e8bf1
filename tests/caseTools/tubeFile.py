# SPDX-License-Identifier: GPL-3.0-or-later
"""A round tube along x as a closed surface in an STL file."""

import math

import stlFile


def write_tube(path, radius, start, end, around=24, along=24):
    """About the axis y = z = 0, with caps at both ends."""
    rings = [[(start + (end - start)*i/along,
               radius*math.cos(2*math.pi*k/around),
               radius*math.sin(2*math.pi*k/around)) for k in range(around)]
             for i in range(along + 1)]
    triangles = []
    for one, two in zip(rings, rings[1:]):
        for k in range(around):
            triangles += [(one[k - 1], two[k - 1], one[k]),
                          (one[k], two[k - 1], two[k])]
    for ring, turn in ((rings[0], 1), (rings[-1], -1)):
        for k in range(around):
            triangles.append(
                ((ring[0][0], 0, 0), ring[k - 1], ring[k])[::turn])
    stlFile.write(path, triangles)
