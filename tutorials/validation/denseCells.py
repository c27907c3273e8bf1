# SPDX-License-Identifier: GPL-3.0-or-later
"""Red cells on 40 % of a channel between plates, driven from rest by a force
with a given stress at the plates: by the kernel of the membranes and the mesh.
The cells are those of etc/caseDicts/redCell in plasma of 1.2 mPa s, so that the
contrast is 5. They are seeded once, with gaps of 0.15 um, and all runs start
from this list of places and directions.

Bounds: cells that hook into each other are drawn to needles of a stretch of 6
and more; runs without such cells stayed below 4.6, and areas within 3 % (a
prototype with 5 uN/m for the shear modulus, the only source; the long runs have
it too, the preset 2.6). The area changes by a tension over the area modulus,
0.5 N/m for a real cell, which needs too short steps; the long runs have 2 mN/m,
four times the preset's.
The viscosity is tau h/(3 mu U) with the stress tau at the plates, half of their
distance h and the mean velocity U. No published value is for this start: the
finest mesh is the reference, and 10 and 5 % are allowed, as for rigid bodies in
suspension.py. The step is proportional to the mesh, 5 us at 0.5 um; it gets
shorter where cells are stretched so far that implicit forces are not enough."""

import math

import results
from common import Case, Row
from redCell import DENSITY, MICRO, PLASMA, PRESET

BOX = (24, 32, 20)

# Cells per micrometre
MESHES = (2, 3, 4)

# Mesh and kernel of the reference
FINEST = (MESHES[-1], 2)

# Stresses at the plates [Pa] and times [ms] with the recommended kernel
LONG_RUNS = ((4.6, 15), (11.5, 10))

# At which the kernels are compared [ms]
TIMES = (0.2, 0.4, 0.6)


def channel(name, stress, end, placements, cells=2, kernel=2, step=1,
            every=20, moduli=""):
    """A case that is solved, and minutes. end: in ms, written each fifth of a
    ms; cells: per micrometre; step: over 10 us/cells; moduli: in place of the
    preset's."""
    half = BOX[1]/2*MICRO
    case = Case(
        f"denseCells-{name}", box=(0, 0, 0, *(x*MICRO for x in BOX)),
        cells=tuple(x*cells for x in BOX), cyclic="xz",
        viscosity=PLASMA/DENSITY, density=DENSITY,
        properties=f"membranes {{ kernel {kernel}; }} output {{ objectsEvery "
                   f"{every}; crossing warn; }} contact {{ law {{ type none; "
                   "} } drivingForce { type acceleration; acceleration "
                   f"({stress/(DENSITY*half)} 0 0); }}",
        shapes="cell { shape { type biconcave; radius 3.91e-6; } material { "
               f'\n#include "{PRESET}"\n {moduli} }} }}',
        placements=placements, p_tolerance=1e-3, U_tolerance=1e-3,
        deltaT=10*MICRO*step/cells, adjustTimeStep="yes",
        endTime=end*1e-3, timePrecision=10,
        writeInterval=0.2e-3, writeFormat="binary")
    return case, case.solve(40000)


def seeded():
    """Placement of all cells, and their area at rest: from their centroids and
    short axes after a first tiny step. A short axis is y in the shape."""
    case, _ = channel(
        "seed", 1e-3, 1e-3, "a { type packed; shape cell; volumeFraction 0.4; "
        "start small; sweeps 2000; } ", step=0.2, every=1)
    listed = []
    for row in case.objects():
        x, y, z = (row[f"shortAxis{axis}"] for axis in "XYZ")
        angle = math.degrees(math.atan2(math.hypot(x, z), y))
        centre = " ".join(repr(row[f"centroid{axis}"]) for axis in "XYZ")
        listed.append(f"{{ centre ({centre}); rotation {{ axis ({z!r} 0 "
                      f"{-x!r}); angle {angle!r}; }} }}")
    return ("a { type listed; shape cell; objects (" + "\n".join(listed)
            + "); }", case.objects()[0]["surface"])


def viscosity(case, stress, start, end=None):
    """Over the viscosity of plasma, mean between two times [ms], or at one."""
    values = [row["fluidVelocityX"] for row in
              results.table(case.path, "global.csv")
              if (start < row["time"]*1e3 <= end if end else
                  abs(row["time"]*1e3 - start) < 0.02)]
    return stress*BOX[1]/2*MICRO*len(values)/(3*PLASMA*sum(values))


def soundness(case, what, minutes, rest):
    """Rows of a run: nodes inside other cells, stretch, volume, and area by
    the area at rest."""
    grid = "h = 0.5 um"
    inside = case.logged(r"inside other objects: (\d+) of")
    cut = case.logged(r"cut\s+themselves: (\d+)")
    rows = case.objects()
    area = [abs(row["surface"]/rest - 1) for row in rows]
    yield Row(f"{what}: most nodes inside other cells at {len(inside)} times",
              grid, 0, max(inside), 0, minutes)
    yield Row(f"{what}: most cells that cut themselves", grid, 0,
              max(cut, default=0), 0, minutes)
    yield Row(f"{what}: largest stretch of a membrane", grid, 1,
              max(row["stretch"] for row in rows), 4, minutes)
    yield Row(f"{what}: largest change of the area of a cell", grid, 0,
              max(area), 0.03, minutes)
    yield Row(f"{what}: largest change of the volume of a cell", grid, 0,
              case.volume_change(), 1e-6, minutes)


def long_runs():
    """Rows of the long runs with two points."""
    placements, rest = seeded()
    for stress, end in LONG_RUNS:
        case, minutes = channel(f"{stress}", stress, end, placements,
                                moduli="shearModulus 5e-6; areaModulus 2e-3;")
        what = f"65 red cells at 40 %, {stress} Pa, {end} ms"
        yield from soundness(case, what, minutes, rest)
        yield Row(f"{what}: viscosity over plasma's, last third",
                  "h = 0.5 um", None, viscosity(case, stress, end*2/3, end),
                  None, minutes)


def kernels():
    """Rows of the kernels and meshes."""
    placements, _ = seeded()
    stress = LONG_RUNS[-1][0]
    found, minutes = {}, {}
    for cells in MESHES:
        for kernel in (2,) if cells == MESHES[-1] else (2, 3):
            case, minutes[cells, kernel] = channel(
                f"{cells}-{kernel}", stress, TIMES[-1], placements, cells,
                kernel)
            found[cells, kernel] = [viscosity(case, stress, time)
                                    for time in TIMES]
    for i, time in enumerate(TIMES):
        finest = found[FINEST][i]
        for (cells, kernel), values in found.items():
            tolerance = {2: 0.1, 3: 0.05}.get(cells) if kernel == 2 else None
            yield Row(f"red cells at 40 %, {stress} Pa, {time} ms: viscosity, "
                      f"{kernel} points", f"h = 1/{cells} um",
                      finest if (cells, kernel) != FINEST else None,
                      values[i], tolerance and tolerance*finest,
                      minutes[cells, kernel])
        apart = {cells: found[cells, 3][i] - found[cells, 2][i]
                 for cells in MESHES[:-1]}
        yield Row(f"the same, {time} ms: 3 points less 2 points, over the one "
                  "with h = 1/2 um", "h = 1/3 um", 2/3, apart[3]/apart[2],
                  1/3, 0)
    case, took = channel("halved", stress, TIMES[-1], placements, step=0.5)
    yield Row(f"red cells at 40 %, {stress} Pa, {TIMES[-1]} ms: viscosity "
              "with half the step over that with the step", "h = 1/2 um", 1,
              viscosity(case, stress, TIMES[-1])/found[2, 2][-1], 0.005, took)


LONG = {"denseCells": long_runs, "cellKernels": kernels}
