#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Diameters of the cell against the force, beside measured ones:

    diameters.py FOLDER

writes diameters.csv and diameters.png in the folder of the case.
"""

import csv
import glob
import os
import re
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # pylint: disable=wrong-import-position

# Suresh et al. 2005, Acta Biomaterialia 1, 15 (by optical tweezers), as in the
# reference data of HemoCell: force [pN], diameter and its bounds [um]
AXIAL = """15.9 9.255 8.352 10.097
19.2 9.584 8.701 10.446
30.6 10.528 9.625 11.390
38.0 11.144 10.076 12.293
46.6 11.862 10.815 12.970
67.4 12.868 11.883 13.874
87.6 13.771 12.580 14.982
108.6 14.346 12.868 15.823
129.7 15.187 13.894 16.624
150.9 15.598 14.428 16.870
173.1 16.070 14.264 17.876
192.8 16.296 14.489 18.020"""
TRANSVERSE = """16.06 6.197 5.581 6.813
19.8 6.279 5.643 6.915
30.7 5.725 5.130 6.320
37.7 5.438 4.822 5.992
46.9 5.068 4.288 5.828
67.7 4.637 3.939 5.356
87.6 4.637 4.001 5.273
109.2 4.596 3.980 5.232
130.0 4.534 3.878 5.191
151.0 4.350 3.775 4.986
172.9 4.596 4.083 5.048
193.0 4.391 3.755 4.945"""


def numbers(text):
    """Rows of numbers."""
    return [[float(v) for v in line.split()] for line in text.splitlines()]


def diameters(path):
    """Extents of the cell along x and z [um], from the state of a time."""
    with open(path, encoding="ascii") as stream:
        match = re.search(r"positions[^(]*?(\d+)\s*\(([^)]*)\)",
                          stream.read())
    values = [1e6*float(v) for v in match.group(2).split()]
    n = len(values)//3
    return [max(values[d*n:(d + 1)*n]) - min(values[d*n:(d + 1)*n])
            for d in (0, 2)]


def main(case):
    """The table and the picture."""
    files = glob.glob(os.path.join(case, "*/uniform/fsiObjects/cell"))
    files.sort(key=lambda f: float(os.path.relpath(f, case).split(os.sep)[0]))
    found = [diameters(f) for f in files[1:]]
    rows = [[a[0], d[0], *a[1:], d[1], *t[1:]] for d, a, t in
            zip(found, numbers(AXIAL), numbers(TRANSVERSE))]
    with open(os.path.join(case, "diameters.csv"), "w",
              encoding="ascii", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(["force", "axial", "measured", "least", "most",
                         "transverse", "measured", "least", "most"])
        writer.writerows(rows)
    for name, first in (("axial", 1), ("transverse", 5)):
        mean = [r[first + 1] for r in rows]
        plt.errorbar([r[0] for r in rows], mean, fmt="ko", mfc="none",
                     yerr=[[r[first + 1] - r[first + 2] for r in rows],
                           [r[first + 3] - r[first + 1] for r in rows]])
        plt.plot([r[0] for r in rows], [r[first] for r in rows], label=name)
        inside = sum(r[first + 2] <= r[first] <= r[first + 3] for r in rows)
        print(f"{name}: {inside} of {len(rows)} inside the bars")
        print("   ", *(f"{r[first]:.2f}" for r in rows))
    plt.xlabel("force [pN]")
    plt.ylabel("diameter [um]")
    plt.legend()
    plt.savefig(os.path.join(case, "diameters.png"), dpi=120)


if __name__ == "__main__":
    main(sys.argv[1])
