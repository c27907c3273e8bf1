# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the outline of a symmetric NACA airfoil of four digits, of the chord 1
and with a closed trailing edge, as lines of x,y:

    makeAirfoil.py FILE [THICKNESS]
"""

import math
import sys


def half(x, thickness):
    """Half of the thickness at x."""
    return 5*thickness*(0.2969*math.sqrt(x) - 0.1260*x - 0.3516*x**2
                        + 0.2843*x**3 - 0.1036*x**4)


def main(path, thickness=0.15, n=200):
    """The outline, from the trailing edge over the upper side."""
    places = [(1 - math.cos(math.pi*i/n))/2 for i in range(n + 1)]
    upper = [(x, half(x, float(thickness))) for x in places]
    upper[0], upper[-1] = (0, 0), (1, 0)
    outline = upper[::-1] + [(x, -y) for x, y in upper[1:-1]]
    with open(path, "w", encoding="ascii") as stream:
        for x, y in outline:
            stream.write(f"{x:.9g},{y:.9g}\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
