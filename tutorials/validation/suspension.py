# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscosity of suspensions of rigid discs and spheres in a shear between walls,
at Re 0.1 with the radius and the shear rate. Lengths are radii, shear rate and
density are 1.

Suspensions are chaotic: two runs with other steps soon have other states, whose
viscosities differ more than the steps' errors. So four states of a run are gone
on with, each for a strain of 0.6, with other steps, stiffnesses of contact and
meshes; a value is the mean of the last halves, by rheology.csv. The
bodies start with the shear's velocity.

Spheres are compared with the formulas of Eilers and of Krieger and Dougherty,

    mu/mu_0 = (1 + 1.25 phi/(1 - phi/0.63))^2,  (1 - phi/0.63)^(-2.5*0.63)

The reference is their mean, the tolerance half of their difference and 5 % of
the reference. Rosti, Brandt and Mitra 2018 (Phys. Rev. Fluids 3, 012301) find
Eilers' at this Re between walls five diameters apart; Fornari et al. 2015
(arXiv 1506.08722) find less where the distance is a small integer multiple of
the diameter, since spheres make layers then. So here it is 6.5 diameters, and
the core, three radii and more from walls, has rows of its own: the stress over
the local shear rate, beside the formulas at the local fraction.
"""

import math

import results
from common import Field, Row, carried, disc, sheared, sphere

VISCOSITY = 10

# Length of the box, distance of the walls and, in three dimensions, depth
BOX = {2: (12, 12), 3: (10, 13, 10)}

# Radii from walls where the core begins
LAYER = 3

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


def formulas(phi):
    """Viscosity of spheres over that of the fluid: mean of both formulas, and
    tolerance."""
    eilers = (1 + 1.25*phi/(1 - phi/0.63))**2
    krieger = (1 - phi/0.63)**(-2.5*0.63)
    middle = (eilers + krieger)/2
    return middle, (eilers - krieger)/2 + 0.05*middle


def box(name, n_dims, cells, step, placements, end, stiffness=None,
        interval=None):
    """A case that is solved, and minutes. cells: to a radius; stiffness over
    the stress of the flow, None: the default; interval: between fields."""
    law = (f"law {{ type elastic; stiffness {stiffness*VISCOSITY}; }}"
           if stiffness else "")
    case = sheared(
        f"suspension-{name}", tuple(x/2 for x in BOX[n_dims]), cells,
        viscosity=VISCOSITY, shapes=SHAPE[n_dims](1, "type rigid; density 1;"),
        placements=placements,
        properties=f"contact {{ range 1; {law} }} "
                   "output { rheology yes; objectsEvery 1; crossing warn; }",
        deltaT=step/(VISCOSITY*cells**2), endTime=end,
        writeInterval=interval or end)
    return case, case.solve(40000)


def mean(case, start, end):
    """Of the viscosity between two strains."""
    values = [row["viscosity"] for row in results.table(
        case.path, "rheology.csv") if start < row["time"] <= end]
    return sum(values)/len(values)


def slab(height, half):
    """Part of the volume of a sphere that is between two heights."""
    low, high = (min(max(x - height, -1), 1) for x in (-half, half))
    return math.pi*(high - low - (high**3 - low**3)/3)


def core(case, start, end):
    """Mean fraction and shear rate in the core between two strains."""
    length, distance, depth = BOX[3]
    h = case.spacing()
    half = round((distance/2 - LAYER)/h)*h
    rows = [row for row in case.objects() if start < row["time"] <= end]
    volume = 2*half*length*depth*len({row["time"] for row in rows})
    phi = sum(slab(row["centroidY"], half) for row in rows)/volume

    nx, ny, nz = case.values["cells"]
    edges = [ny//2 + sign*round(half/h) for sign in (-1, 1)]
    rates = []
    for time in results.times(case.path):
        if start < float(time) <= end:
            u = Field(case, "U", 0, time).values
            means = [sum(sum(u[nx*(j + ny*k):nx*(j + 1 + ny*k)])
                         for j in (edge - 1, edge) for k in range(nz))
                     for edge in edges]
            rates.append((means[1] - means[0])/(2*nx*nz)/(2*half))
    return phi, sum(rates)/len(rates)


def states(n_dims, phi, cells, strains, step=1):
    """Placements of the bodies at strains of a run from a random state, the
    case, and minutes."""
    shape = SHAPE[n_dims].__name__
    case, minutes = box(
        f"{n_dims}D-{phi}-{cells}-{step}", n_dims, cells, step,
        f"a {{ type packed; shape {shape}; "
        + START[n_dims].format(phi), strains[-1], interval=0.25)
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
        listed, _, _ = states(2, phi, meshes[0], (1, 2, 3, 4))
        values = {}
        for cells in meshes:
            rows, values[cells] = compared(2, phi, cells, listed)
            yield from rows
        for cells, tolerance in zip(meshes[:-1], (0.1, 0.05)):
            yield Row(f"discs at {phi:.0%}, viscosity, over that with D/h = "
                      f"{2*meshes[-1]}", f"D/h = {2*cells}", 1,
                      values[cells]/values[meshes[-1]], tolerance, 0)


def spheres(fractions=(0.1, 0.2, 0.3, 0.4), cells=4, end=3, step=4):
    """Second half of a run from a random state: all of the box, and its core.
    The last state of the densest one gone on with: steps, stiffnesses and
    meshes."""
    grid = f"D/h = {2*cells}, step {step}"
    for phi in fractions:
        listed, case, minutes = states(3, phi, cells, (end,), step)
        value = mean(case, end/2, end)
        reference, tolerance = formulas(phi)
        yield Row(f"spheres at {phi:.0%}, viscosity", grid, reference, value,
                  tolerance, minutes)
        inside, rate = core(case, end/2, end)
        reference, tolerance = formulas(inside)
        yield Row(f"spheres at {phi:.0%}, the core, which has {inside:.1%}, "
                  "viscosity", grid, reference, value/rate, tolerance, 0)
    what = f"spheres at {fractions[-1]:.0%}, the last state, viscosity"
    here, minutes = gone_on(3, phi, cells, step, listed)
    for other, of, tolerance in (
            ((cells, step/4, None), f"step {step/4:g}", 0.03),
            ((cells, step/16, None), f"step {step/16:g}", 0.03),
            ((cells, step, 0.1), "stiffness 0.1", 0.03),
            ((cells, step, 10), "stiffness 10", 0.03),
            ((cells*3//2, step, None), f"D/h = {3*cells}", 0.1)):
        value, minutes = gone_on(3, phi, *other[:2], listed, other[2])
        yield Row(f"{what}, over that with {of}, {value:.3f}", grid, 1,
                  here/value, tolerance, minutes)


LONG = {"discSuspension": discs, "suspension": spheres}
