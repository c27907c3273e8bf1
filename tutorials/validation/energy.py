# SPDX-License-Identifier: GPL-3.0-or-later
"""Energies of the fluid and the bodies in it, and what is asked of them."""

import math
import statistics

import results
from common import Field, Row


def energies(case):
    """Kinetic energy of fluid and bodies and elastic energy at the written
    times after the start; in two dimensions per unit of thickness."""
    h, n = case.spacing(), case.dimensions()
    thickness = h if n == 2 else 1
    table = {round(row["time"], 9): row
             for row in results.table(case.path, "global.csv")}
    found = []
    for time in results.times(case.path)[1:]:
        fields = [Field(case, *of, time).values for of in
                  [("signedDistance", 0)] + [("U", i) for i in range(n)]]
        # The fluid's part of cut cells, from the distance
        fluid = 0.5*h**n*sum(
            min(max(0.5 + phi/h, 0), 1)*sum(u*u for u in velocity)
            for phi, *velocity in zip(*fields))
        row = table[round(float(time), 9)]
        found.append((fluid + row["kineticEnergy"]/thickness,
                      row["elasticEnergy"]/thickness))
    return found


def largest_rise(what, grid, totals, minutes):
    """Row: no total energy is above the one before it."""
    rise = max(b - a for a, b in zip(totals, totals[1:]))/totals[0]
    return Row(f"{what}largest rise of the total energy over that at first",
               grid, 0, max(rise, 0), 1e-3, minutes)


def orders(what, grid, ladder, ratio, minutes, end):
    """Rows: orders of both energies, from what energies() gives on three meshes
    whose cells are smaller by a ratio from one to the next, up to a time."""
    n = len(ladder[0])
    for i, name in enumerate(("kinetic", "elastic")):
        coarse, fine = ([abs(a[i] - b[i]) for a, b in zip(*pair)]
                        for pair in zip(ladder, ladder[1:]))
        for when, error, smaller in (
                (f"at {end}", coarse[-1], fine[-1]),
                (f"up to {end}", max(coarse), max(fine))):
            yield Row(f"{what}order of the {name} energy {when}", grid, 2,
                      math.log(error/smaller, ratio), 1, minutes)
        yield Row(f"{what}order of the {name} energy in the median of {n} "
                  "times", grid, 2, statistics.median(
                      math.log(a/b, ratio) for a, b in zip(coarse, fine)),
                  1, minutes)
