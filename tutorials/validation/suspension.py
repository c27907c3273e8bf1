# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscosity of suspensions of rigid discs and spheres in a shear between walls,
at Re 0.1 with the radius and the shear rate. Lengths are radii, shear rate and
density are 1.

Suspensions are chaotic: two runs with other steps soon have other states, whose
viscosities differ more than the steps' errors. So two states of a run are gone
on with, each for a strain of 0.6, with other steps, stiffnesses of contact and
meshes; a value is the mean of the last half of both, by rheology.csv. The
bodies start with the shear's velocity.

Spheres are compared with Eilers' formula

    mu/mu_0 = (1 + 1.25 phi/(1 - phi/0.63))^2

which Rosti, Brandt and Mitra 2018 (Phys. Rev. Fluids 3, 012301) find at this Re
between walls five diameters apart; their value is the mean of a whole run.
"""

import math

import results
from common import Row, carried, disc, sheared, sphere

VISCOSITY = 10

# Distance of the walls, and length of the box
SIDE = {2: 12, 3: 10}

SHAPE = {2: disc, 3: sphere}

# Of a lattice with gaps of 0.1, spheres at 40 % would stay a crystal
START = {
    2: "areaFraction {}; minimumGap 0.1; wallGap 0.1; }}",
    3: "volumeFraction {}; minimumGap 0.05; wallGap 0.05; acrossCyclic yes; "
       "start small; sweeps 100000; }}",
}

# dt nu/h^2
STEPS = (4, 1, 0.25)

# Over the stress of the flow
STIFFNESSES = (0.1, 1, 10)

# Strain that a state is gone on with
STRAIN = 0.6


def eilers(phi):
    """Viscosity over that of the fluid."""
    return (1 + 1.25*phi/(1 - phi/0.63))**2


def box(name, n_dims, cells, step, placements, end, stiffness=None):
    """A case that is solved, and minutes. cells: to a radius; stiffness over
    the stress of the flow, None: the default."""
    law = (f"law {{ type elastic; stiffness {stiffness*VISCOSITY}; }}"
           if stiffness else "")
    case = sheared(
        f"suspension-{name}", (SIDE[n_dims]/2,)*n_dims, cells,
        viscosity=VISCOSITY, shapes=SHAPE[n_dims](1, "type rigid; density 1;"),
        placements=placements,
        properties=f"contact {{ range 1; {law} }} "
                   "output { rheology yes; objectsEvery 1; crossing warn; }",
        deltaT=step/(VISCOSITY*cells**2), endTime=end, writeInterval=end)
    return case, case.solve(40000)


def mean(case, start, end):
    """Of the viscosity between two strains."""
    values = [row["viscosity"] for row in results.table(
        case.path, "rheology.csv") if start < row["time"] <= end]
    return sum(values)/len(values)


def states(n_dims, phi, cells, strains, step=1):
    """Placements of the bodies at strains of a run from a random state, the
    case, and minutes."""
    shape = SHAPE[n_dims].__name__
    case, minutes = box(
        f"{n_dims}D-{phi}-{cells}-{step}", n_dims, cells, step,
        f"a {{ type packed; shape {shape}; "
        + START[n_dims].format(phi), strains[-1])
    rows = case.objects()
    listed = []
    for strain in strains:
        time = min((row["time"] for row in rows),
                   key=lambda t, s=strain: abs(t - s))
        listed.append(
            f"a {{ type listed; shape {shape}; objects (" + " ".join(
                carried(*(row.get(f"centroid{axis}", 0) for axis in "XYZ"))
                for row in rows if row["time"] == time) + "); }")
    return listed, case, minutes


def gone_on(n_dims, phi, cells, step, listed, stiffness=None):
    """Mean viscosity of the states, and minutes."""
    total = minutes = 0
    for i, placements in enumerate(listed):
        case, took = box(f"{n_dims}D-{phi}-{cells}-{step}-{stiffness}-{i}",
                         n_dims, cells, step, placements, STRAIN, stiffness)
        total += mean(case, STRAIN/2, STRAIN)/len(listed)
        minutes += took
    return total, minutes


def compared(n_dims, phi, cells, listed):
    """Rows of a mesh: steps over the least, stiffnesses over the middle one;
    and the viscosity with the middle step."""
    what = f"{SHAPE[n_dims].__name__}s at {phi:.0%}, viscosity"
    grid = f"D/h = {2*cells}"
    found = {step: gone_on(n_dims, phi, cells, step, listed) for step in STEPS}
    rows = [Row(f"{what}, step {step}, over that with {STEPS[-1]}", grid, 1,
                found[step][0]/found[STEPS[-1]][0], 0.03, found[step][1])
            for step in STEPS[:-1]]
    value, minutes = found[1]
    rows.append(Row(f"{what}, step 1", grid, None, value, None, minutes))
    for stiffness in STIFFNESSES:
        other, minutes = gone_on(n_dims, phi, cells, 1, listed, stiffness)
        rows.append(Row(f"{what}, stiffness {stiffness}, over that by default",
                        grid, 1, other/value, 0.03, minutes))
    return rows, value


def discs(fractions=(0.2, 0.4), meshes=(4, 6, 8)):
    """Steps, stiffnesses and meshes, all from the states of the first mesh."""
    for phi in fractions:
        listed, _, _ = states(2, phi, meshes[0], (2, 4))
        values = {}
        for cells in meshes:
            rows, values[cells] = compared(2, phi, cells, listed)
            yield from rows
        for cells, tolerance in zip(meshes[:-1], (0.1, 0.05)):
            yield Row(f"discs at {phi:.0%}, viscosity, over that with D/h = "
                      f"{2*meshes[-1]}", f"D/h = {2*cells}", 1,
                      values[cells]/values[meshes[-1]], tolerance, 0)


def spheres(fractions=(0.1, 0.2, 0.3, 0.4), cells=4, end=5):
    """Mean of the second half of a run, and steps and stiffnesses."""
    for phi in fractions:
        listed, case, minutes = states(3, phi, cells, (end/2, end))
        yield Row(f"spheres at {phi:.0%}, viscosity (Eilers)",
                  f"D/h = {2*cells}", eilers(phi), mean(case, end/2, end),
                  0.1*eilers(phi), minutes)
        rows, _ = compared(3, phi, cells, listed[-1:])
        yield from rows


def two_meshes(fractions=(0.3, 0.4), strain=3, step=4):
    """The same state gone on with on two meshes."""
    for phi in fractions:
        listed, _, _ = states(3, phi, 4, (strain,), step)
        coarse, fine = (gone_on(3, phi, cells, step, listed)
                        for cells in (4, 6))
        yield Row(f"spheres at {phi:.0%}, viscosity, step {step} (Eilers)",
                  "D/h = 12", eilers(phi), fine[0], 0.1*eilers(phi), fine[1])
        yield Row(f"spheres at {phi:.0%}, viscosity, step {step}, over that "
                  "with D/h = 12", "D/h = 8", 1, coarse[0]/fine[0], 0.1,
                  coarse[1])


LONG = {"discSuspension": discs, "suspension": spheres,
        "twoSphereMeshes": two_meshes}
