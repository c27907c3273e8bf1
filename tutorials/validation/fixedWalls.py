# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixed surfaces in three dimensions: periodic arrays of spheres in Stokes flow
(Zick & Homsy 1982) and a round tube whose wall is one closed surface."""

import math

from common import Case, Row, body, placed
import results
import stlFile

# Volume fraction, drag coefficient; cells per period for diameters of at least
# 8 and 16 cells. There must be the band of the level set, 4 cells, between a
# sphere and its own image, so that the densest array starts at 12
ARRAYS = ((0.064, 2.810, (17, 33)), (0.216, 7.442, (16, 22)),
          (0.027, 2.008, (22, 43)))

FIXED = "motion { type fixed; }"


def flux(case):
    """Flow through the plane in the middle of x [m3/s]: all internal faces in
    the order of their cells, of each cell those to x, y and z."""
    time = results.times(case.path)[-1]
    phi = results.field(case.path, time, "phi")
    nx, ny, nz = case.values["cells"]
    total = 0
    face = 0
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                if i + 1 < nx:
                    total += phi[face] if i + 1 == nx//2 else 0
                    face += 1
                face += (j + 1 < ny) + (k + 1 < nz)
    if face != len(phi):
        raise ValueError(f"{face} internal faces, {len(phi)} values")
    return total


def array(fraction, reference, cells):
    """One sphere in a periodic cube of side 1, Stokes flow from rest, until the
    velocity is within exp(-8) of its last. Steps of h^2/nu: with larger ones
    the flow depends on them (theory, below (4.12))."""
    diameter = (6*fraction/math.pi)**(1/3)
    end = 8/(3*math.pi*diameter*reference)
    return diameter, Case(
        f"spheres-{fraction}-{cells}", box=(0, 0, 0, 1, 1, 1),
        cells=(cells,)*3, cyclic="xyz", viscosity=1, deltaT=1/cells**2,
        endTime=end, writeInterval=end,
        properties="drivingForce { type acceleration; "
                   "acceleration (1e-3 0 0); }",
        shapes=body("sphere", f"sphere; radius {diameter/2};",
                    "density 1; E 1;", FIXED),
        placements=placed("sphere", (0.5 + 0.13/cells, 0.5 - 0.21/cells,
                                     0.5 + 0.32/cells)))


def spheres():
    """Drag of periodic arrays: K = F/(3 pi mu D U) with the mean pressure
    gradient on all of the volume as F, and the mean velocity of all of the
    volume as U."""
    for fraction, reference, ladder in ARRAYS:
        for cells in ladder:
            diameter, case = array(fraction, reference, cells)
            minutes = case.solve()
            drag = 1e-3/(3*math.pi*diameter*flux(case))
            width = diameter*cells
            yield Row(f"array of spheres, {fraction}, K",
                      f"D/h = {width:.1f}", reference, drag,
                      reference*(0.03 if width < 15.9 else 0.01), minutes,
                      (f"array of spheres, {fraction}", cells))


def ring(radius, n):
    """Corners of a polygon with the area of a circle, about the axis."""
    radius *= (2*math.pi/(n*math.sin(2*math.pi/n)))**0.5
    return [(radius*math.cos(2*math.pi*i/n), radius*math.sin(2*math.pi*i/n))
            for i in range(n)]


def write_tube(path, radii, ends, n, n_along):
    """Writes an STL of what lies between two cylinders along x about the
    origin; triangles face outward."""
    inner, outer = (ring(r, n) for r in radii)
    places = [ends[0] + (ends[1] - ends[0])*i/n_along
              for i in range(n_along + 1)]
    triangles = []

    def quadrangle(a, b, c, d):
        triangles.extend(((a, b, c), (a, c, d)))

    for (a, c), (b, d) in zip(zip(inner, outer),
                              zip(inner[1:] + inner[:1],
                                  outer[1:] + outer[:1])):
        for x, y in zip(places, places[1:]):
            quadrangle((x, *a), (y, *a), (y, *b), (x, *b))
            quadrangle((x, *c), (x, *d), (y, *d), (y, *c))
        x, y = ends
        quadrangle((x, *a), (x, *b), (x, *d), (x, *c))
        quadrangle((y, *a), (y, *c), (y, *d), (y, *b))
    stlFile.write(path, triangles)


def pipe(cells):
    """A tube with R = cells h, along the cyclic direction x."""
    h = 1/cells
    n = 2*cells + 6
    half = n*h/2
    length = 8*h
    case = Case(
        f"tube-{cells}", box=(0, -half, -half, length, half, half),
        cells=(8, n, n), cyclic="x", viscosity=1, deltaT=0.1*h, endTime=2,
        writeInterval=2,
        properties="drivingForce { type acceleration; acceleration (1 0 0); }",
        shapes=body("tube", 'surface; file "tube.stl";', "density 1; E 1;",
                    FIXED),
        placements=placed("tube", (length/2, 0.0013, -0.0017)))
    write_tube(f"{case.path}/tube.stl", (1, 2*half), (-length, 2*length),
               round(8*cells), 3*8)
    return case


def tube():
    """Flow over pi G R^4/(8 nu)."""
    for cells in (5, 10):
        case = pipe(cells)
        minutes = case.solve()
        yield Row("round tube, flow", f"R/h = {cells}", 1,
                  flux(case)*8/math.pi, 0.03 if cells == 5 else 0.005,
                  minutes, ("round tube", cells))


CASES = {"spheres": spheres, "tube": tube}
