# SPDX-License-Identifier: GPL-3.0-or-later
"""A neo-Hookean capsule on the axis of a round tube, the fluid inside a closed
surface, in Stokes flow that a force drives. Lengths are radii of the tube, the
mean velocity without the capsule and the density are 1; the capillary number is
the viscosity times this velocity over the shear modulus.

A capsule that is small and stiff moves as a rigid sphere: on the axis nothing
moves in its skin. The velocity of a sphere without drag, over the largest one
of the flow, is

    (1 - 2/3 s^2 - 0.20217 s^5)/(1 - 0.75857 s^5)

with the ratio s of the radii (Haberman & Sayre 1958, David Taylor Model Basin
report 1143; the coefficients as codes for transport in pores have them).
A large soft capsule is compared with the finest mesh.

Kernels make a membrane thicker by about half a cell for the flow (measured at a
plane wall with another code). So a film may differ from the finest mesh by half
of the difference of the cells, and a velocity by this times the slope of the
formula, which is 1.15 at s = 0.6 and 0.8 for the velocity over the mean one."""

import math

import results
from common import Case, Row
from fixedWalls import flux
from vessel import VESSEL, write_vessel

VISCOSITY = 20
LENGTH = 4
MESHES = (8, 12, 16)

# Off the mesh's planes of symmetry
AXIS = -0.0017

# Ratio of the radii, capillary number, time, step over a cell's length
STIFF = (0.6, 0.02, 1, 0.1)
SOFT = (0.8, 0.1, 2, 0.2)

# Of the velocity over the mean one by the ratio of the radii
SLOPE = 1.15


def haberman_sayre(ratio):
    """Velocity of a rigid sphere over the mean velocity."""
    return 2*(1 - 2/3*ratio**2 - 0.20217*ratio**5)/(1 - 0.75857*ratio**5)


def capsule(cells, ratio, capillary, end, step):
    """The case, solved, and minutes; cells: to the tube's radius."""
    half = 1 + 3/cells
    modulus = VISCOSITY/capillary
    case = Case(
        f"capsuleInTube-{ratio}-{cells}",
        box=(0, -half, -half, LENGTH, half, half),
        cells=(LENGTH*cells, 2*cells + 6, 2*cells + 6), cyclic="x",
        viscosity=VISCOSITY, deltaT=step/cells, endTime=end,
        writeInterval=end/4, p_tolerance=1e-5, U_tolerance=1e-6,
        shapes=VESSEL + "capsule { shape { type sphere; radius "
        f"{ratio}; }} material {{ type membrane; law neoHookean; density 1; "
        f"shearModulus {modulus}; bendingModulus {0.005*modulus*ratio**2}; }} "
        "}",
        placements="a { type inPlace; shape vessel; } b { type listed; shape "
                   f"capsule; objects ({{ centre (1.5 {AXIS} 0); }}); }}",
        properties="drivingForce { type acceleration; acceleration "
                   f"({8*VISCOSITY} 0 0); }} output {{ objectsEvery 1; }} "
                   "contact { law { type none; } }")
    write_vessel(f"{case.path}/vessel.stl",
                 [((0.0013/cells - 1 + i*(2 + LENGTH)/24, AXIS), (1, 0))
                  for i in range(25)], 8*cells)
    return case, case.solve(40000)


def measured(case, end):
    """Velocity of the capsule over the mean one of the flow, and the least
    distance of a node from the wall, at the end."""
    rows = [row for row in case.objects() if row["shape"] == "capsule"]
    first = next(row for row in rows if row["time"] > 0.75*end)
    velocity = ((rows[-1]["unwrappedX"] - first["unwrappedX"])
                / (rows[-1]["time"] - first["time"]))
    nodes = next(nodes for shape, nodes, _ in results.state(
        case.path, results.times(case.path)[-1]).values()
                 if shape == "capsule")
    film = 1 - max(math.hypot(y - AXIS, z) for _, y, z in nodes)
    return velocity/(flux(case)/math.pi), film


def soundness(case, what, grid):
    """Rows of the volume and of nodes in the wall."""
    yield Row(f"{what}: largest change of its volume", grid, 0,
              case.volume_change(), 1e-6, 0)
    yield Row(f"{what}: most nodes inside the wall", grid, 0,
              max(case.logged(r"inside other objects: (\d+) of")), 0, 0)


def stiff():
    """Velocity beside the rigid sphere's, and its limit."""
    ratio, _, end, _ = STIFF
    what = f"stiff capsule of {ratio} R in a tube"
    exact = haberman_sayre(ratio)
    found = {}
    for cells in MESHES:
        case, minutes = capsule(cells, *STIFF)
        grid = f"R/h = {cells}"
        found[cells], _ = measured(case, end)
        yield Row(f"{what}: velocity over the mean velocity (Haberman)", grid,
                  exact, found[cells], 0.5/cells*SLOPE, minutes,
                  ("stiff capsule", cells))
        yield from soundness(case, what, grid)
    a, b = MESHES[-2:]
    yield Row(f"{what}: the same, limit of the first order in h",
              f"R/h = {a}, {b}", exact,
              (b*found[b] - a*found[a])/(b - a), 0.02*exact, 0)


def soft():
    """Velocity and film beside those of the finest mesh."""
    ratio, capillary, end, _ = SOFT
    what = f"capsule of {ratio} R in a tube, Ca {capillary}"
    cases = {cells: capsule(cells, *SOFT) for cells in MESHES}
    found = {cells: measured(case, end) for cells, (case, _) in cases.items()}
    for cells, (case, minutes) in cases.items():
        grid = f"R/h = {cells}"
        layer = 0.5*(1/cells - 1/MESHES[-1])
        for i, name, slope in ((0, "velocity over the mean velocity", SLOPE),
                               (1, "least film over R", 1)):
            yield Row(f"{what}: {name}", grid,
                      found[MESHES[-1]][i] if layer else None,
                      found[cells][i], slope*layer if layer else None,
                      minutes, (f"{what}: {name}", cells))
        yield from soundness(case, what, grid)


def in_tube():
    """Both."""
    yield from stiff()
    yield from soft()


LONG = {"capsuleInTube": in_tube}
