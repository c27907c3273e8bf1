# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a vessel that forks as STL: makeVessel.py FILE

It is a plane figure, extruded along z. Its ends are outside the box of the
mesh.
"""

import sys

import stlFile

TRUNK = [(-0.5, -0.4), (1, -0.4), (1, 0.4), (-0.5, 0.4)]
MIDDLE = [(1, -0.4), (1.5, 0), (1, 0.4)]
UPPER = [(1, 0.4), (1.5, 0), (3.8, 0.51), (3.8, 1.24)]
LOWER = [(x, -y) for x, y in UPPER[::-1]]
BOTTOM, TOP = 0.103, 0.897


def main(path):
    """The STL file."""
    stlFile.write(path, stlFile.extruded((TRUNK, MIDDLE, UPPER, LOWER),
                                         BOTTOM, TOP))


if __name__ == "__main__":
    main(*sys.argv[1:])
