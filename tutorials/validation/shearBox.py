# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in simple shear between two walls, the other directions cyclic.

Lengths are radii, the shear rate and the fluid's density are 1: the viscosity
is 1/Re. Flow and body start with the shear's own velocity.

A sphere turns with half the shear rate, a spheroid of ratio r in the plane of
the shear (Jeffery 1922) once in 2 pi (r + 1/r), with r^2/(r^2 + 1) at most and
1/(r^2 + 1) at least. A filled neo-Hookean sphere takes the steady ellipsoid of
Roscoe 1967 and Gao, Hu and Ponte Castaneda 2011: the strain inside is uniform,
so that the solution in Stokes flow is exact; the numbers here are by quadrature
of the polarisation tensor, for Ca = mu gamma/G. From a sphere at rest it is
within 1e-3 of it at gamma t = 1, 2.5 and 6. All of these are for an unbounded
fluid without inertia.
"""

import math

from common import Row, at, body, carried, disc, sheared, sphere

# Exact: Ca, Taylor's deformation, angle of the long axis over pi
ROSCOE = ((0.05, 0.0624, 0.2381), (0.2, 0.2417, 0.2035), (0.5, 0.5243, 0.1464))

# Strains of 1e-4 at Re = 0.1: a stress of the fluid is 10
KINDS = {"rigid": "type rigid; density 1;", "stiff": "density 1; E 1e5;"}


def shear_box(name, shape, shapes, cells, side=10, reynolds=0.1, n_dims=3,
              more="", **parameters):
    """A box with a body of a shape in its middle, radius/h = cells. more:
    entries of fsiProperties."""
    return sheared(
        name, (side/2,)*n_dims, cells, viscosity=1/reynolds, shapes=shapes,
        placements=f"all {{ type listed; shape {shape}; objects "
        f"({carried(0, 0)}); }}",
        properties="output { objectsEvery 1; }" + more, **parameters)


def turning(kind, cells, n_dims=3, side=10):
    """A disc or sphere turns: angular velocity at gamma t = 2, and minutes."""
    shape, shapes = (("sphere", sphere) if n_dims == 3 else ("disc", disc))
    case = shear_box(
        f"turning-{shape}-{kind}-{cells}", shape, shapes(1, KINDS[kind]), cells,
        side, n_dims=n_dims, deltaT=0.08/cells, endTime=2, writeInterval=2)
    minutes = case.solve()
    return -case.objects()[-1]["angularVelocityZ"], minutes


def sphere_turns():
    """Angular velocity of a free sphere."""
    for kind in KINDS:
        for cells in (4, 6, 8):
            rate, minutes = turning(kind, cells)
            what = f"sphere in shear, {kind}, angular velocity"
            yield Row(what, f"a/h = {cells}", 0.5, rate,
                      0.03*0.5 if cells >= 8 else None, minutes, (what, cells))


def half_turn(rows, start):
    """Time that the long axis takes for half a turn, from a time on."""
    angles = []
    for row in rows:
        angle = -math.atan2(row["longAxisY"], row["longAxisX"])
        if angles:
            last = angles[-1]["angle"]
            angle = last + math.remainder(angle - last, math.pi)
        angles.append({"time": row["time"], "angle": angle})
    first = at(angles, "time", start, "angle")
    return at(angles, "angle", first + math.pi, "time") - start


def spheroid():
    """Ratio 2, radius that of the long axis, which starts along the flow."""
    for cells in (4, 6, 8):
        case = shear_box(
            f"spheroid-{cells}", "spheroid",
            body("spheroid", "ellipsoid; semiAxes (1 0.5 0.5);",
                 KINDS["rigid"]), cells,
            deltaT=0.08/cells, endTime=9.2, writeInterval=2.3)
        minutes = case.solve()
        rows = [row for row in case.objects() if row["time"] >= 1]
        rates = [-row["angularVelocityZ"] for row in rows]
        for what, reference, value in (
                ("period", 5*math.pi, 2*half_turn(rows, 1)),
                ("largest angular velocity", 0.8, max(rates)),
                ("least angular velocity", 0.2, min(rates))):
            yield Row(f"spheroid in shear, {what}", f"a/h = {cells}", reference,
                      value, 0.03*reference if cells >= 8 else None, minutes,
                      (f"spheroid {what}", cells))


def soft(capillary, cells, end, step):
    """A filled neo-Hookean sphere, its volume term 20 G: the last row of its
    objects.csv, the minutes."""
    viscosity = 20
    G = viscosity/capillary
    kappa = 40*G
    E = 9*(kappa/2)*G/(3*(kappa/2) + G)
    case = shear_box(
        f"soft-{capillary}-{cells}", "sphere",
        sphere(1, f"type neoHookean; density 1; E {E!r}; "
               f"areaStiffness {kappa!r};"), cells, 8, 1/viscosity,
        deltaT=step/cells, endTime=end, writeInterval=end/4)
    minutes = case.solve()
    return case.objects(), minutes


def large_step():
    """Deformation with a large time step over that with a quarter of it."""
    found = {}
    for step in (0.06, 0.015):
        rows, minutes = soft(0.2, 4, 4, step)
        found[step] = rows[-1]["deformation"]
    return Row("neo-Hookean sphere in shear, Ca 0.2, D with a step of "
               "0.06 h/(a gamma) over that with a quarter", "a/h = 4", 1,
               found[0.06]/found[0.015], 0.04, minutes)


def soft_sphere():
    """Deformation and angle of the steady ellipsoid."""
    yield large_step()
    for (capillary, deformation, angle), end in zip(ROSCOE, (2, 4, 8)):
        for cells in (4, 6, 8):
            rows, minutes = soft(capillary, cells, end, 0.03)
            row = rows[-1]
            what = f"neo-Hookean sphere in shear, Ca {capillary}"
            checked = cells >= 8
            yield Row(f"{what}, D", f"a/h = {cells}", deformation,
                      row["deformation"],
                      0.04*deformation if checked else None, minutes,
                      (f"{what}, D", cells))
            yield Row(f"{what}, angle over pi", f"a/h = {cells}", angle,
                      row["flowAngle"]/math.pi, 0.01 if checked else None,
                      minutes, (f"{what}, angle", cells))


CASES = {"sphereTurns": sphere_turns, "spheroid": spheroid,
         "softSphere": soft_sphere}
