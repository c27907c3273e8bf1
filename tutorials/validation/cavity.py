# SPDX-License-Identifier: GPL-3.0-or-later
"""Driven cavity without objects, against a spectral-quality solution (Re 1000)
and a Richardson-extrapolated one (Re 100); cavity.csv."""

import csv

from common import Case, Field, Row


def rms(case, column):
    """Root mean square of the differences from a column of cavity.csv."""
    u, v = Field(case, "U", 0), Field(case, "U", 1)
    with open("cavity.csv", encoding="ascii") as stream:
        rows = [row for row in csv.DictReader(stream) if row[column]]
    errors = []
    for row in rows:
        s = float(row["position"])
        value = u.at(0.5, s) if row["component"] == "u" else v.at(s, 0.5)
        errors.append(value - float(row[column]))
    return (sum(e*e for e in errors)/len(errors))**0.5


def cavity():
    """Velocity profiles on the centre lines."""
    for reynolds, grids, end in ((100, (32, 64, 128), 20),
                                 (1000, (64, 128, 256), 30)):
        case = None
        for n in grids:
            coarse = case
            case = Case(
                f"cavity{reynolds}-{n}", cells=(n, n), viscosity=1/reynolds,
                walls={"top": "(1 0 0)"}, deltaT=0.8/n,
                endTime=end if coarse is None else end/2,
                writeInterval=end/2)
            if coarse is not None:
                case.start_from(coarse)
            minutes = case.solve()
            tolerance = {(100, 64): 1e-2, (100, 128): 5e-3, (1000, 128): 1e-2,
                         (1000, 256): 6e-3}.get((reynolds, n))
            what = f"driven cavity, Re {reynolds}, rms of the profiles"
            yield Row(what, f"h = 1/{n}", 0, rms(case, f"Re{reynolds}"),
                      tolerance, minutes, (what, n))


CASES = {"cavity": cavity}
