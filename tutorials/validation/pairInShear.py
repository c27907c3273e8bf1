# SPDX-License-Identifier: GPL-3.0-or-later
"""Two discs, and two spheres, that pass each other in a shear between walls at
a Reynolds number of 0.01 with the radius and the shear rate. Lengths are radii,
shear rate and density are 1.

Stokes flow is reversible: bodies that do not touch leave with the offset across
the flow with which they came, and the path is the same forwards and backwards.
The least gap is compared with the finest mesh.
"""

import math

from common import Row, at, carried, disc, sheared, sphere

VISCOSITY = 100

# dt nu/h^2
STEP = 10

# Half of the box along the flow, across it, and along the vorticity
HALF = {2: (10, 5), 3: (8, 5, 5)}

START = 4

SHAPE = {2: disc, 3: sphere}


def passing(n_dims, cells, offset):
    """Rows of the relative position (x, y, gap) of the bodies by time, and the
    minutes. cells: to a radius; offset of the centres across the flow."""
    shape = SHAPE[n_dims].__name__
    # Off the mesh's planes of symmetry
    bodies = " ".join(
        carried(0.031 - sign*START, 0.017 + sign*offset/2,
                0.023*(n_dims - 2)) for sign in (1, -1))
    step = STEP/(VISCOSITY*cells**2)
    case = sheared(
        f"pair-{n_dims}D-{cells}-{offset}", HALF[n_dims], cells,
        viscosity=VISCOSITY, shapes=SHAPE[n_dims](1, "type rigid; density 1;"),
        placements=f"a {{ type listed; shape {shape}; objects ({bodies}); }}",
        properties="output { objectsEvery 1; }", deltaT=step,
        endTime=round(5*START/offset/step)*step, writeInterval=1000)
    minutes = case.solve(40000)
    rows = case.objects()
    path = []
    for a, b in zip(rows[::2], rows[1::2]):
        way = [a[f"unwrapped{d}"] - b[f"unwrapped{d}"] for d in "XYZ"[:n_dims]]
        path.append({"time": a["time"], "x": way[0], "y": way[1],
                     "gap": math.hypot(*way) - 2})
    return path, minutes


def compare(n_dims, meshes, offset):
    """Rows of the meshes, the last one the finest."""
    name = f"two {SHAPE[n_dims].__name__}s that pass in shear, offset {offset}"
    found = {cells: passing(n_dims, cells, offset) for cells in meshes}
    least = {cells: min(row["gap"] for row in path)
             for cells, (path, _) in found.items()}
    for cells, (path, minutes) in found.items():
        grid = f"D/h = {2*cells}"
        before, after = (at(path, "x", sign*0.9*START, "y") for sign in (-1, 1))
        yield Row(f"{name}, offset after over that before", grid, 1,
                  after/before, 0.02, minutes)
        apart = max(abs(at(path, "x", -x, "y") - at(path, "x", x, "y"))
                    for x in (0.5, 1, 1.5, 2, 2.5, 3))
        yield Row(f"{name}, path before less path after, in radii", grid, 0,
                  apart, None, 0)
        yield Row(f"{name}, least gap, in radii", grid,
                  least[meshes[-1]] if cells < meshes[-1] else None,
                  least[cells],
                  0.05*least[cells] if cells < meshes[-1] else None, 0)


def discs():
    """Two dimensions."""
    for offset in (2, 1.5):
        yield from compare(2, (4, 6, 12), offset)


def spheres():
    """Three dimensions."""
    yield from compare(3, (4,), 2)


LONG = {"pair": discs, "spherePair": spheres}
