# SPDX-License-Identifier: GPL-3.0-or-later
"""Membranes inside the fluid in two dimensions."""

import math
import os
import subprocess
import sys

import apart
import fsiCase
import pressed
import results
import sameAnswers
import steps
from shearCase import STEP, VISCOSITY, capsule

TUTORIAL = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "../../../tutorials/denseSuspension")
sys.path.append(TUTORIAL)
import suspension  # noqa: E402

CAPILLARY = 0.05


def theory(contrast):
    """Deformation and angle of a nearly circular drop in Stokes flow: a strain
    alone would deform it by the capillary number, whatever its viscosity. It
    comes back in the time mu (1 + contrast) a/tension (doc/choices.md)."""
    turn = CAPILLARY*(1 + contrast)
    return (CAPILLARY/math.sqrt(1 + turn**2),
            math.pi/4 - 0.5*math.atan(turn))


def drop(report, folder, contrast):
    """The deformation comes to the theory as the mesh gets finer."""
    found = []
    for cells in (4, 8, 16):
        case = capsule(
            folder, f"drop{contrast}-{cells}", cells=cells, plane=True,
            law="drop", modulus="tension", capillary=CAPILLARY, endTime=1.5,
            deltaT=0.16/cells, material=f"innerViscosity {contrast*VISCOSITY};")
        case.run("fsiPisoFoam")
        rows = results.table(case.path, "objects.csv")
        found.append((rows[-1]["deformation"], rows[-1]["inclination"]))
        change = max(abs(r["area"]/rows[0]["area"] - 1) for r in rows)
        report.check(f"drop {contrast}: the area stays", change < 1e-6, change)
    deformation, angle = theory(contrast)
    print(f"    contrast {contrast}: D and angle", *(
        f"{D:.4f} {turned:.3f}" for D, turned in found),
          f"theory {deformation:.4f} {angle:.3f}")
    errors = [abs(D/deformation - 1) for D, _ in found]
    report.check(f"drop {contrast}: D as in theory",
                 errors[-1] < 0.09 and errors[-1] < 0.6*errors[0], str(found))
    report.check(f"drop {contrast}: its angle",
                 abs(found[-1][1] - angle) < 0.03, str(found))


def dense(report, folder):
    """120 red cells on 40 % of a channel, 12 cells of the mesh across: the
    error of this mesh stays as it was measured. The limit of this packing is
    2.38, from 2.836, 2.497 and 2.430 with 12, 24 and 36 cells across
    (doc/choices.md): 19 % above it with the kernel that the guide asks for, of
    which 0.6 % are of the step. A wider one, with which nodes come near the
    walls, is to have less than twice that error."""
    for kernel in (2, 3):
        path = os.path.join(folder, f"dense{kernel}")
        fsiCase.copy(TUTORIAL, path)
        made = subprocess.run(
            [sys.executable, os.path.abspath(suspension.__file__), "case",
             "channel", "40", "120", "5"], cwd=path, check=True,
            stdout=subprocess.PIPE, text=True, env={
                **os.environ, "PYTHONPATH": os.path.dirname(fsiCase.__file__)})
        path = os.path.join(path, made.stdout.strip())
        fsiCase.set_entry(os.path.join(path, "constant/fsiProperties"),
                          "kernel", kernel)
        for command in ("blockMesh", "seedObjects", "fsiPisoFoam"):
            fsiCase.run(path, command)
        viscosity = suspension.driving_viscosity(path)
        print(f"    dense lines, {kernel} points: {viscosity:.3f}")
        report.check(f"dense lines, {kernel} points: viscosity",
                     0 < viscosity/2.38 - 1 < (0.2 if kernel == 2 else 0.38),
                     viscosity)


def sinking(report, folder):
    """A heavy capsule sinks nearly as a rigid disc does. There are no walls as
    long as no disc is placed."""
    speeds = []
    for shape in ("capsule", "disc"):
        case = fsiCase.Case(
            os.path.join(folder, f"sinking-{shape}"), box=(-4, -4, 4, 4),
            cells=(64, 64), viscosity=VISCOSITY, gravity="(0 -1 0)",
            deltaT=STEP, endTime=1,
            properties="output { objectsEvery 1; }",
            shapes="capsule { shape { type circle; radius 1; } material { type "
                   "membrane; law neoHookean; density 2; shearModulus 60; } } "
                   "disc { shape { type circle; radius 1; } material { type "
                   "rigid; density 2; } }",
            placements=f"a {{ type listed; shape {shape}; objects "
                       "({ centre (0 0 0); }); }").set_up()
        case.run("fsiPisoFoam")
        speeds.append(results.table(case.path, "objects.csv")[-1]["velocityY"])
    report.check("a heavy capsule sinks as a disc", speeds[1] < 0
                 and 0.85 < speeds[0]/speeds[1] < 1.1, str(speeds))


def check(report, folder):
    """Drops, ranks, restarts, implicit forces."""
    for contrast in (0.2, 1, 5):
        drop(report, folder, contrast)
    sinking(report, folder)
    dense(report, folder)
    sameAnswers.ranks(report, folder, True)
    sameAnswers.restart(report, folder, True)
    steps.stiff(report, folder, True)
    steps.stiff(report, folder, True, 0.2, STEP/4)
    steps.drop(report, folder)
    apart.check(report, folder, True)
    pressed.check(report, folder)
