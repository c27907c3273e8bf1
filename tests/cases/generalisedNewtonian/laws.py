#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow between plates, and around a disc that turns in a ring, of OpenFOAM's
viscosity models, beside the solutions of the equations in one dimension.

    laws.py FOLDER
"""

import math
import os
import sys

import fsiCase
import results

# Largest error of a velocity over the largest velocity with 32 cells across
TOLERANCE = 0.015

LAWS = {
    "thinning": ("powerLaw", {"k": 1, "n": 0.5, "nuMin": 1e-6, "nuMax": 1e3}),
    "thickening": ("powerLaw",
                   {"k": 1, "n": 1.5, "nuMin": 1e-4, "nuMax": 1e3}),
    "Carreau": ("BirdCarreau", {"nu0": 1, "nuInf": 0.05, "k": 10, "n": 0.4}),
    "Cross": ("CrossPowerLaw", {"nu0": 1, "nuInf": 0.05, "m": 10, "n": 0.6}),
    "Casson": ("Casson", {"m": 0.5, "tau0": 0.1, "nuMin": 1e-3, "nuMax": 100}),
    "Bingham": ("HerschelBulkley", {"k": 1, "n": 0.7, "tau0": 0.1,
                                    "nu0": 100}),
}

VISCOSITIES = {
    "powerLaw": lambda g, k, n, nuMin, nuMax:
        max(nuMin, min(nuMax, k*g**(n - 1))),
    "BirdCarreau": lambda g, nu0, nuInf, k, n:
        nuInf + (nu0 - nuInf)*(1 + (k*g)**2)**((n - 1)/2),
    "CrossPowerLaw": lambda g, nu0, nuInf, m, n:
        nuInf + (nu0 - nuInf)/(1 + (m*g)**n),
    "Casson": lambda g, m, tau0, nuMin, nuMax:
        max(nuMin, min(nuMax, (math.sqrt(tau0/g) + math.sqrt(m))**2)),
    "HerschelBulkley": lambda g, k, n, tau0, nu0:
        min(nu0, (tau0 + k*g**n)/g),
}


def entries(model, coefficients):
    """The text of transportProperties."""
    text = " ".join(f"{k} {v};" for k, v in coefficients.items())
    return f"transportModel {model};\n{model}Coeffs {{ {text} }}\n"


def bisect(function, target):
    """Where a rising function has a value, between 1e-9 and 1e4."""
    low, high = math.log(1e-9), math.log(1e4)
    for _ in range(60):
        middle = 0.5*(low + high)
        if function(math.exp(middle)) < target:
            low = middle
        else:
            high = middle
    return math.exp(low)


def shear_rate(law, stress):
    """The shear rate at a stress over the density."""
    model, coefficients = LAWS[law]
    return bisect(lambda g: g*VISCOSITIES[model](g, **coefficients), stress)


def profile(law, n):
    """Velocities in the middle of n cells between plates that are 1 apart,
    with the driving acceleration 1."""
    parts = 3200//n
    h = 0.5/(n//2*parts)
    velocity, found = 0, []
    for i in range(n//2*parts):
        if i % parts == parts//2:
            found.append(velocity)
        velocity += h*shear_rate(law, 0.5 - (i + 0.5)*h)
    return found + found[::-1]


def plates(folder, law, n):
    """Largest error over the largest velocity."""
    h = 1/n
    case = fsiCase.Case(
        os.path.join(folder, f"{law}{n}"), box=(0, 0, 4*h, 1), cells=(4, n),
        cyclic="x", deltaT=0.05, endTime=15, writeInterval=300,
        properties="drivingForce { type acceleration; "
                   "acceleration (1 0 0); }\n")
    case.file("constant/transportProperties", entries(*LAWS[law]))
    case.set_up().run("fsiPisoFoam")
    velocity = results.field(case.path, "15", "U")[::12]
    exact = profile(law, n)
    return max(abs(a - b) for a, b in zip(velocity, exact))/max(exact)


def between_plates(report, folder, law):
    """The error is small, and falls with the mesh."""
    errors = [plates(folder, law, n) for n in (16, 32)]
    print(f"    {law} between plates: error {errors[0]:.4f}, {errors[1]:.4f}")
    report.check(f"{law}, flow between plates",
                 errors[1] < TOLERANCE and errors[1] < 0.6*errors[0],
                 f"errors {errors}")


def ring(path, inner, outer):
    """Writes half a ring; its polygon. The halves have a slit of 0.002."""
    start = math.asin(0.001/inner)
    angles = [start + (math.pi - 2*start)*i/300 for i in range(301)]
    points = [(outer*math.cos(a), outer*math.sin(a)) for a in angles]
    points += [(inner*math.cos(a), inner*math.sin(a)) for a in angles[::-1]]
    with open(path, "w", encoding="ascii") as stream:
        stream.writelines(f"{x:.10g},{y:.10g}\n" for x, y in points)
    return points


def torque(law, inner, outer):
    """Torque over the density that turns the inner circle with 1 rad/s."""
    def speed(moment):
        n, step = 400, math.log(outer/inner)/400
        radii = (inner*math.exp((i + 0.5)*step) for i in range(n))
        return sum(step*shear_rate(law, moment/(2*math.pi*r*r))
                   for r in radii)

    return bisect(speed, 1)


def turning_disc(report, folder, law):
    """The torque of a disc that turns in a ring, both cut by the mesh."""
    n, inner, outer = 40, 0.2, 0.4
    case = fsiCase.Case(
        os.path.join(folder, "ring" + law), cells=(n, n), deltaT=0.01,
        endTime=0.5, properties="output { objectsEvery 1; }", shapes="""
        disc
        {
            shape { type circle; radius 0.2; }
            material { type rigid; density 1; }
            motion { type rotating; angularVelocity (0 0 1); }
        }
        half
        {
            shape { type polygon; file "half.csv"; }
            material { type rigid; density 1; }
            motion { type fixed; }
        }""")
    polygon = ring(os.path.join(case.path, "half.csv"), outer, outer + 0.08)
    x, y = results.centroid(polygon)
    case.append("system/seedObjectsDict", f"""placements
    {{
        disc {{ type listed; shape disc;
            objects ({{ centre (0.5013 0.4987 0); }}); }}
        ring {{ type listed; shape half; objects
            (
                {{ centre ({0.5013 + x} {0.4987 + y} 0); }}
                {{ centre ({0.5013 - x} {0.4987 - y} 0); rotation 180; }}
            ); }}
    }}""")
    case.file("constant/transportProperties", entries(*LAWS[law]))
    case.set_up().run("fsiPisoFoam")
    rows = [row for row in results.table(case.path, "objects.csv")
            if row["shape"] == "disc"]
    ratio = -rows[-1]["torqueZ"]*n/torque(law, inner, outer)
    print(f"    {law}, disc in a ring: {ratio:.4f} of the exact torque")
    report.check(f"{law}, torque of a disc in a ring", abs(ratio - 1) < 0.015,
                 f"{ratio} of the exact one")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for law in LAWS:
        report.attempt(f"{law}, plates", between_plates, report, folder, law)
    for law in ("thinning", "Carreau"):
        report.attempt(f"{law}, ring", turning_disc, report, folder, law)
    sys.exit(report.failures > 0)


if __name__ == "__main__":
    main(sys.argv[1])
